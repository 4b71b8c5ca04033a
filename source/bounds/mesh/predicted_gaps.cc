// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <boost/serialization/map.hpp>

#include <algorithm>
#include <cmath>

#include "bounds/mesh/predicted_gaps.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Of the gap of a cell that is refined, what its children keep together.
    constexpr double kept_part = 0.5;



    /// The number of the corner of the unit cell that a point is, or
    /// numbers::invalid_unsigned_int.
    template <int dim>
    unsigned int
    corner_of_unit_cell(const Point<dim> &point)
    {
      for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
        if (GeometryInfo<dim>::unit_cell_vertex(v) == point)
          return v;
      return numbers::invalid_unsigned_int;
    }



    template <int dim>
    Point<dim>
    unit_centre()
    {
      Point<dim> centre;
      for (unsigned int d = 0; d < dim; ++d)
        centre[d] = 0.5;
      return centre;
    }
  } // namespace



  template <int dim>
  PredictedGaps<dim>::PredictedGaps(const SplitMesh<dim>      &mesh,
                                    const std::vector<double> &of_simplices,
                                    const MPI_Comm             communicator)
  {
    const auto gap = [&](const unsigned int t) {
      return std::max(0., of_simplices[t]);
    };
    std::vector<double> gaps(mesh.vertices.size()), volumes(gaps);
    for (unsigned int t = 0; t < of_simplices.size(); ++t)
      for (const unsigned int v : mesh.simplices[t].vertices)
        {
          gaps[v] += gap(t);
          volumes[v] += volume(mesh.corners(mesh.simplices[t]));
        }
    for (unsigned int t = 0; t < of_simplices.size(); ++t)
      {
        const auto &simplex = mesh.simplices[t];
        Gap        &of_cell = known[mesh.cells[simplex.cell].id];
        of_cell.value += gap(t);
        for (unsigned int i = 0; i <= dim; ++i)
          if (const unsigned int corner =
                corner_of_unit_cell<dim>(simplex.unit_corners[i]);
              corner != numbers::invalid_unsigned_int)
            of_cell.densities[corner] =
              gaps[simplex.vertices[i]] / volumes[simplex.vertices[i]];
      }
    known = Utilities::MPI::broadcast(communicator, known);
  }



  template <int dim>
  Vector<float>
  PredictedGaps<dim>::indicators(const Triangulation<dim> &triangulation) const
  {
    Vector<float> result(triangulation.n_active_cells());
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        result[cell->active_cell_index()] = std::sqrt(of_cell(cell).value);
    return result;
  }



  template <int dim>
  double
  PredictedGaps<dim>::Gap::density(const Point<dim> &unit_point) const
  {
    double result = 0;
    for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
      result += densities[v] *
                GeometryInfo<dim>::d_linear_shape_function(unit_point, v);
    return result;
  }



  template <int dim>
  typename PredictedGaps<dim>::Gap
  PredictedGaps<dim>::of_cell(
    const typename Triangulation<dim>::cell_iterator &cell) const
  {
    if (const auto gap = known.find(cell->id()); gap != known.end())
      return gap->second;

    Assert(cell->level() > 0, ExcInternalError());
    const auto parent    = cell->parent();
    const Gap  of_parent = of_cell(parent);
    Gap        result;
    double     own_weight = 0, weights = 0;
    for (unsigned int c = 0; c < parent->n_children(); ++c)
      {
        const auto density_at = [&](const Point<dim> &point_of_child) {
          return of_parent.density(
            GeometryInfo<dim>::child_to_cell_coordinates(point_of_child, c));
        };
        const double weight =
          Utilities::fixed_power<2>(density_at(unit_centre<dim>()));
        weights += weight;
        if (parent->child(c) != cell)
          continue;
        own_weight = weight;
        for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
          result.densities[v] =
            density_at(GeometryInfo<dim>::unit_cell_vertex(v));
      }
    if (weights > 0)
      result.value = kept_part * of_parent.value * own_weight / weights;
    return result;
  }



  template class PredictedGaps<2>;
  template class PredictedGaps<3>;
} // namespace ElastoPlastic
