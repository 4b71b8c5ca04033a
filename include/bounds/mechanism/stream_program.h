// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_stream_program_h
#define bounds_mechanism_stream_program_h

#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  /// The mechanism in plane strain or of a body of revolution that takes least
  /// plastic work among those with a stream function (StreamElement). It is
  /// continuous, so nothing passes through the sides of triangles; but they may
  /// slide along each other, which takes the work k |[v_t]| per area, with the
  /// yield stress in shear k of the weaker material. So they may along fixed
  /// sides and along a rough indenter.
  ///
  /// Velocities are up to a factor. The force is what has been minimised; work
  /// and errors are not yet computed.
  /// @throws ConvergenceError, UnboundedError if there is no mechanism.
  VelocityField<2>
  find_stream(const SplitBody<2> &body, const double tolerance);
} // namespace ElastoPlastic

#endif
