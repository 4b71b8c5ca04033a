// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_sheet_program_h
#define bounds_mechanism_sheet_program_h

#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  /// The mechanism in plane stress, or in plane strain with friction, that
  /// takes least plastic work among all continuous piecewise quadratic
  /// velocities. The strain rate is linear on a triangle: so the work is at
  /// most a third of the area times the sum of that at the corners, because it
  /// is a convex function; and with friction, the rate is in the dual cone of
  /// the yield condition everywhere because it is at the corners.
  ///
  /// Velocities are up to a factor. The force is what has been minimised; work
  /// and errors are not yet computed.
  /// @throws ConvergenceError, UnboundedError if there is no mechanism.
  VelocityField<2>
  find_motion_of_sheet(const SplitBody<2> &body, const double tolerance);
} // namespace ElastoPlastic

#endif
