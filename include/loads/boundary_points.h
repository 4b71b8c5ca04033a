// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loads_boundary_points_h
#define loads_boundary_points_h

#include <deal.II/dofs/dof_handler.h>

#include <set>
#include <utility>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Where locally owned cells need the values that are prescribed on
  /// @p boundaries: the nodes, for displacements, and the quadrature points of
  /// the faces, for tractions. Each point with its boundary.
  template <int dim>
  std::vector<std::pair<types::boundary_id, Point<dim>>>
  boundary_points(const DoFHandler<dim>              &dof_handler,
                  const std::set<types::boundary_id> &boundaries);
} // namespace ElastoPlastic

#endif
