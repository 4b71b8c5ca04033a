// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <map>
#include <set>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "base/ghost_values.h"
#include "base/text.h"
#include "evaluation/probes.h"

namespace ElastoPlastic
{
  namespace
  {
    const std::string probe_entry = "Output/Probe points";

    /// How far outside of a cell, relative to its size, a point still belongs
    /// to it, because the mesh has straight sides only; and what is rounding.
    constexpr double widest_gap = 0.1, rounding = 1e-8;



    bool
    is_identifier(const std::string &name)
    {
      return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
      });
    }



    /// Which components of tensors there are, and what they are called.
    template <int dim>
    std::vector<std::pair<std::string, TableIndices<2>>>
    tensor_components()
    {
      std::vector<std::pair<std::string, TableIndices<2>>> components = {
        {"xx", {0, 0}}, {"yy", {1, 1}}, {"zz", {2, 2}}, {"xy", {0, 1}}};
      if (dim == 3)
        components.insert(components.end(), {{"xz", {0, 2}}, {"yz", {1, 2}}});
      return components;
    }



    /// How far @p point is outside of @p cell, relative to the cell, and where
    /// it is on the unit cell, or the next point there; infinity if that is
    /// far.
    template <int dim>
    std::pair<double, Point<dim>>
    place_in_cell(const typename Triangulation<dim>::active_cell_iterator &cell,
                  const Point<dim> &point)
    {
      const double outside = std::numeric_limits<double>::infinity();
      if (!cell->bounding_box().point_inside(point, 0.5))
        return {outside, point};
      try
        {
          const Point<dim> unit_point =
            MappingQ1<dim>().transform_real_to_unit_cell(cell, point);
          const Point<dim> nearest =
            GeometryInfo<dim>::project_to_unit_cell(unit_point);
          const double distance = unit_point.distance(nearest);
          return {distance <= rounding ? 0. : distance, nearest};
        }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
        {
          return {outside, point};
        }
    }
  } // namespace



  template <int dim>
  ProbePoints<dim>::ProbePoints(
    const std::string                               &text,
    const BoundaryNames                             &boundaries,
    const parallel::distributed::Triangulation<dim> &triangulation)
    : triangulation(triangulation)
  {
    std::set<std::string> names;
    for (const auto &[name, id] : boundaries)
      names.insert(name);
    for (const std::string &part : split(probe_entry, text, '|'))
      {
        probes.push_back(read(part));
        if (!names.insert(probes.back().name).second)
          throw InputError(probe_entry,
                           part,
                           "there is another point, or a boundary, that is "
                           "called '" +
                             probes.back().name + "'. Choose another name.");
      }
    locate(widest_gap);
  }



  template <int dim>
  typename ProbePoints<dim>::Probe
  ProbePoints<dim>::read(const std::string &text) const
  {
    const std::size_t colon = text.find(':');
    Probe             probe;
    probe.name = Utilities::trim(text.substr(0, colon));
    const auto coordinates =
      split(probe_entry,
            colon == std::string::npos ? "" : text.substr(colon + 1),
            ',');
    bool is_probe = is_identifier(probe.name) && coordinates.size() == dim;
    for (unsigned int d = 0; is_probe && d < dim; ++d)
      if (const auto value = as_number(coordinates[d]);
          value && std::isfinite(*value))
        probe.point[d] = *value;
      else
        is_probe = false;
    if (!is_probe)
      throw InputError(probe_entry,
                       text,
                       std::string("it must look like 'name: ") +
                         (dim == 2 ? "x, y" : "x, y, z") +
                         "', with letters, digits and '_' in the name, and '|' "
                         "between points. " +
                         decimal_point_hint);
    return probe;
  }



  template <int dim>
  std::vector<std::string>
  ProbePoints<dim>::names() const
  {
    std::vector<std::string> result;
    for (const Probe &probe : probes)
      {
        for (unsigned int d = 0; d < dim; ++d)
          result.push_back(probe.name + "_displacement_" + "xyz"[d]);
        for (const std::string kind : {"_stress_", "_strain_"})
          for (const auto &component : tensor_components<dim>())
            result.push_back(probe.name + kind + component.first);
        result.push_back(probe.name + "_equivalent_plastic_strain");
      }
    return result;
  }



  template <int dim>
  std::vector<std::optional<typename ProbePoints<dim>::Place>>
  ProbePoints<dim>::locate(const double widest) const
  {
    // For each probe, how far it is outside of the nearest cell, and the cell.
    using Rank = std::array<double, 5>;
    std::vector<Rank>                 nearest(probes.size());
    std::vector<std::optional<Place>> places(probes.size());
    for (Rank &place : nearest)
      place.fill(std::numeric_limits<double>::infinity());
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        for (unsigned int i = 0; i < probes.size(); ++i)
          {
            const auto [distance, unit_point] =
              place_in_cell<dim>(cell, probes[i].point);
            if (distance > widest)
              continue;
            Rank       rank = {{distance}};
            const auto id   = cell->id().template to_binary<dim>();
            std::copy(id.begin(), id.end(), rank.begin() + 1);
            if (rank < nearest[i])
              {
                nearest[i] = rank;
                places[i]  = Place{cell, unit_point};
              }
          }

    const auto of_ranks =
      Utilities::MPI::all_gather(communicator_of(triangulation), nearest);
    for (unsigned int i = 0; i < probes.size(); ++i)
      {
        Rank first = nearest[i];
        for (const auto &of_rank : of_ranks)
          first = std::min(first, of_rank[i]);
        if (first[0] > widest)
          report_outside(probes[i]);
        if (nearest[i] != first)
          places[i].reset();
      }
    return places;
  }



  template <int dim>
  void
  ProbePoints<dim>::report_outside(const Probe &probe) const
  {
    std::array<double, dim + 1> nearest;
    nearest.fill(std::numeric_limits<double>::infinity());
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          {
            std::array<double, dim + 1> vertex;
            vertex[0] = probe.point.distance(cell->vertex(v));
            for (unsigned int d = 0; d < dim; ++d)
              vertex[d + 1] = cell->vertex(v)[d];
            nearest = std::min(nearest, vertex);
          }
    for (const auto &of_rank :
         Utilities::MPI::all_gather(communicator_of(triangulation), nearest))
      nearest = std::min(nearest, of_rank);

    Point<dim> vertex;
    std::copy(nearest.begin() + 1, nearest.end(), &vertex[0]);
    throw InputError(probe_entry,
                     probe.name + ": " +
                       Patterns::Tools::to_string(probe.point),
                     "that point is outside of the body. The nearest node of "
                     "its mesh is (" +
                       Patterns::Tools::to_string(vertex) +
                       "). Coordinates are those of the undeformed body.");
  }



  template <int dim>
  std::vector<double>
  ProbePoints<dim>::compute(const DoFHandler<dim>    &dof_handler,
                            const SolidOperator<dim> &solid,
                            const VectorType         &u) const
  {
    if (probes.empty())
      return {};
    const auto        &fe     = dof_handler.get_fe();
    const auto         places = locate(std::numeric_limits<double>::infinity());
    const VectorType   ghosted_u  = ghosted_copy(u, dof_handler);
    const auto         components = tensor_components<dim>();
    const unsigned int n          = dim + 2 * components.size() + 1;
    std::vector<double> values(n * probes.size());

    for (unsigned int i = 0; i < probes.size(); ++i)
      if (places[i])
        {
          Vector<double> nodal(fe.n_dofs_per_cell());
          typename DoFHandler<dim>::active_cell_iterator(
            &triangulation,
            places[i]->cell->level(),
            places[i]->cell->index(),
            &dof_handler)
            ->get_dof_values(ghosted_u, nodal);
          for (unsigned int k = 0; k < nodal.size(); ++k)
            values[n * i + fe.system_to_component_index(k).first] +=
              nodal(k) * fe.shape_value(k, places[i]->unit_point);
        }

    const FE_DGQArbitraryNodes<dim> at_points(QGauss<1>(fe.degree + 1));
    solid.for_each_cell(u, [&](const auto &cell, const auto &points) {
      for (unsigned int i = 0; i < probes.size(); ++i)
        if (places[i] && places[i]->cell->id() == cell->id())
          for (unsigned int q = 0; q < points.size(); ++q)
            {
              const double weight =
                at_points.shape_value(q, places[i]->unit_point);
              double *value = &values[n * i + dim];
              for (const auto *const tensor :
                   {&points[q].stress, &points[q].strain})
                for (const auto &component : components)
                  *value++ += weight * (*tensor)[component.second];
              *value += weight * points[q].equivalent_plastic_strain;
            }
    });
    Utilities::MPI::sum(values, communicator_of(triangulation), values);
    return values;
  }



  template class ProbePoints<2>;
  template class ProbePoints<3>;



  template <int dim>
  BoundaryDisplacements<dim>::BoundaryDisplacements(
    const LoadedBody<dim>                           &body,
    const parallel::distributed::Triangulation<dim> &triangulation)
    : kinematics(body.strain_model.kinematics)
  {
    std::map<types::boundary_id, double> areas;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() &&
              out_of_plane_length(face->center(), kinematics) >
                1e-10 * face->diameter())
            areas[face->boundary_id()] += face->measure();
    for (const auto &[name, id] : body.boundary_conditions.names())
      if (Utilities::MPI::max(areas[id], communicator_of(triangulation)) > 0.)
        boundaries[name] = id;
  }



  template <int dim>
  std::vector<std::string>
  BoundaryDisplacements<dim>::names() const
  {
    std::vector<std::string> result;
    for (const auto &[name, id] : boundaries)
      for (unsigned int d = 0; d < dim; ++d)
        result.push_back(name + "_displacement_" + "xyz"[d]);
    return result;
  }



  template <int dim>
  std::vector<double>
  BoundaryDisplacements<dim>::compute(const DoFHandler<dim> &dof_handler,
                                      const VectorType      &u) const
  {
    const auto                 &fe = dof_handler.get_fe();
    FEFaceValues<dim>           values(fe,
                             QGauss<dim - 1>(fe.degree + 1),
                             update_values | update_JxW_values |
                               update_quadrature_points);
    const VectorType            ghosted_u = ghosted_copy(u, dof_handler);
    std::vector<Tensor<1, dim>> displacements(values.n_quadrature_points);

    // The integrals of the components of u, and of 1.
    std::map<types::boundary_id, std::array<double, dim + 1>> integrals;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              values.reinit(cell, f);
              values[FEValuesExtractors::Vector(0)].get_function_values(
                ghosted_u, displacements);
              auto &integral = integrals[cell->face(f)->boundary_id()];
              for (const unsigned int q : values.quadrature_point_indices())
                {
                  const double area =
                    values.JxW(q) *
                    out_of_plane_length(values.quadrature_point(q), kinematics);
                  for (unsigned int d = 0; d < dim; ++d)
                    integral[d] += area * displacements[q][d];
                  integral[dim] += area;
                }
            }

    std::vector<double> sums;
    for (const auto &[name, id] : boundaries)
      sums.insert(sums.end(), integrals[id].begin(), integrals[id].end());
    Utilities::MPI::sum(sums, communicator_of(dof_handler), sums);
    std::vector<double> means;
    for (unsigned int i = 0; i < sums.size(); i += dim + 1)
      for (unsigned int d = 0; d < dim; ++d)
        means.push_back(sums[i + d] / sums[i + dim]);
    return means;
  }



  template class BoundaryDisplacements<2>;
  template class BoundaryDisplacements<3>;
} // namespace ElastoPlastic
