// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_smooth_heights_h
#define indenter_smooth_heights_h

#include <deal.II/base/table.h>

#include "indenter/indenter.h"

namespace ElastoPlastic
{
  /// A surface without kinks through @p heights on a regular grid with the
  /// distances @p spacing, at the point @p x seen from the first of them. Along
  /// the lines of the grid it is the monotone cubic interpolation of
  /// @cite fritsch_butland_1984: it turns in grid points only, and is straight
  /// where they are in line. Between four lines it is their Coons patch.
  template <int dim>
  IndenterSurface<dim>
  smooth_surface(const Table<dim - 1, double> &heights,
                 const Tensor<1, dim - 1>     &spacing,
                 const Point<dim - 1>         &x);
} // namespace ElastoPlastic

#endif
