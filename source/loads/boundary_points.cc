// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include "loads/boundary_points.h"

namespace ElastoPlastic
{
  template <int dim>
  std::vector<std::pair<types::boundary_id, Point<dim>>>
  boundary_points(const DoFHandler<dim>              &dof_handler,
                  const std::set<types::boundary_id> &boundaries)
  {
    const auto               &fe = dof_handler.get_fe();
    const Quadrature<dim - 1> nodes(
      fe.base_element(0).get_unit_face_support_points());
    FEFaceValues<dim> at_nodes(fe, nodes, update_quadrature_points);
    FEFaceValues<dim> at_quadrature_points(fe,
                                           QGauss<dim - 1>(fe.degree + 1),
                                           update_quadrature_points);

    std::vector<std::pair<types::boundary_id, Point<dim>>> result;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              boundaries.count(cell->face(f)->boundary_id()) > 0)
            for (auto *const points : {&at_nodes, &at_quadrature_points})
              {
                points->reinit(cell, f);
                for (const auto &point : points->get_quadrature_points())
                  result.emplace_back(cell->face(f)->boundary_id(), point);
              }
    return result;
  }



  template std::vector<std::pair<types::boundary_id, Point<2>>>
  boundary_points(const DoFHandler<2> &, const std::set<types::boundary_id> &);
  template std::vector<std::pair<types::boundary_id, Point<3>>>
  boundary_points(const DoFHandler<3> &, const std::set<types::boundary_id> &);
} // namespace ElastoPlastic
