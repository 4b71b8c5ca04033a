// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_quadrature_points_h
#define mechanics_quadrature_points_h

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>

#include "mechanics/cell_kernel.h"
#include "mechanics/point_tangents.h"

namespace ElastoPlastic
{
  /// Calls @p use with batch, lane, quadrature point and its place, for all
  /// @p n_points of each cell of this process.
  template <int dim, typename Use>
  void
  for_each_quadrature_point(const CellKernel<dim, PointTangents<dim>> &kernel,
                            const unsigned int                         n_points,
                            const Use                                 &use)
  {
    const unsigned int n_points_per_line =
      std::lround(std::pow(n_points, 1. / dim));
    const FE_Nothing<dim> fe;
    FEValues<dim>         values(fe,
                         QGauss<dim>(n_points_per_line),
                         update_quadrature_points);
    for (unsigned int batch = 0; batch < kernel.n_batches(); ++batch)
      for (unsigned int lane = 0; lane < kernel.n_cells(batch); ++lane)
        {
          values.reinit(typename Triangulation<dim>::active_cell_iterator(
            kernel.cell(batch, lane)));
          for (unsigned int q = 0; q < n_points; ++q)
            use(batch, lane, q, values.quadrature_point(q));
        }
  }
} // namespace ElastoPlastic

#endif
