// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_surface_row_h
#define evaluation_surface_row_h

#include <deal.II/base/point.h>

namespace ElastoPlastic
{
  using namespace dealii;

  /// A row of surface_profile.csv: a point of the contact surface at the end of
  /// a load step. In two dimensions, third components are zero.
  struct SurfaceRow
  {
    unsigned int step = 0;
    double       time = 0;
    /// Of Output/Profile lines, from 1; in two dimensions 0.
    unsigned int line = 0;
    /// In the undeformed body.
    Point<3>     position;
    Tensor<1, 3> displacement;
    /// To the indenter in its present position; not a number where it does not
    /// reach.
    double gap              = 0;
    double contact_pressure = 0;
    /// On the body; and 1 where that sticks to the indenter.
    Tensor<1, 3> contact_shear;
    double       stick = 0;
  };
} // namespace ElastoPlastic

#endif
