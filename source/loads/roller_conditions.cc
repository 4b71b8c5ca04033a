// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/compatibility.h"
#include "loads/supports.h"
#include "mesh/boundary_faces.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The normal of the plane through the middles of the edges, not
    /// normalised.
    template <int dim, typename Face>
    Tensor<1, dim>
    normal_to(const Face &face)
    {
      if constexpr (dim == 2)
        return cross_product_2d(face->vertex(1) - face->vertex(0));
      else
        return cross_product_3d(face->vertex(3) - face->vertex(0),
                                face->vertex(2) - face->vertex(1));
    }
  } // namespace



  template <int dim>
  unsigned int
  common_normal_axis(const DoFHandler<dim>   &dof_handler,
                     const types::boundary_id boundary)
  {
    std::array<double, dim> largest_deviation;
    largest_deviation.fill(0.);
    for (const auto &[cell, f] : owned_faces(dof_handler, {boundary}))
      for (unsigned int d = 0; d < dim; ++d)
        for (const unsigned int v : cell->face(f)->vertex_indices())
          largest_deviation[d] =
            std::max(largest_deviation[d],
                     std::abs(cell->face(f)->vertex(v)[d] -
                              cell->face(f)->vertex(0)[d]) /
                       cell->face(f)->diameter());
    for (unsigned int d = 0; d < dim; ++d)
      if (Utilities::MPI::max(largest_deviation[d],
                              communicator_of(dof_handler)) < 1e-10)
        return d;
    return dim;
  }



  template <int dim>
  ComponentMask
  components_of_normals(const DoFHandler<dim>   &dof_handler,
                        const types::boundary_id boundary)
  {
    std::array<double, dim> largest;
    largest.fill(0.);
    for (const auto &[cell, f] : owned_faces(dof_handler, {boundary}))
      {
        const Tensor<1, dim> normal = normal_to<dim>(cell->face(f));
        for (unsigned int d = 0; d < dim; ++d)
          largest[d] =
            std::max(largest[d], std::abs(normal[d]) / normal.norm());
      }
    ComponentMask components(dim, false);
    for (unsigned int d = 0; d < dim; ++d)
      components.set(d,
                     Utilities::MPI::max(largest[d],
                                         communicator_of(dof_handler)) > 1e-10);
    return components;
  }



  void
  add_sliding_condition(
    const AffineConstraints<double>::ConstraintLine &line,
    const std::map<types::global_dof_index, double> &fixed_values,
    const AffineConstraints<double>                 &hanging_nodes,
    AffineConstraints<double>                       &constraints)
  {
    const double rounding_noise = 1e-10;
    auto         terms          = line.entries; // sum of all terms = 0
    terms.emplace_back(line.index, -1.);

    std::pair<types::global_dof_index, double> solved_for(line.index, 0.);
    for (const auto &[dof, coefficient] : terms)
      if (std::abs(coefficient) > std::abs(solved_for.second) &&
          fixed_values.count(dof) == 0 && !hanging_nodes.is_constrained(dof) &&
          !constraints.is_constrained(dof))
        solved_for = {dof, coefficient};
    if (std::abs(solved_for.second) < rounding_noise)
      return;

    constraints.add_line(solved_for.first);
    for (const auto &[dof, coefficient] : terms)
      if (dof != solved_for.first)
        constraints.add_entry(solved_for.first,
                              dof,
                              -coefficient / solved_for.second);
  }



  template unsigned int
  common_normal_axis(const DoFHandler<2> &, const types::boundary_id);
  template unsigned int
  common_normal_axis(const DoFHandler<3> &, const types::boundary_id);
  template ComponentMask
  components_of_normals(const DoFHandler<2> &, const types::boundary_id);
  template ComponentMask
  components_of_normals(const DoFHandler<3> &, const types::boundary_id);
} // namespace ElastoPlastic
