// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_flux_program_h
#define bounds_mechanism_flux_program_h

#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  /// The mechanism in space that takes least plastic work among velocities that
  /// are linear on each tetrahedron and change no volume. Their normal
  /// components are continuous (the element of Brezzi, Douglas and Marini
  /// @cite nedelec_1986); neighbours may slide along each other, which takes
  /// the work k |[v_t]| per area. So they may along fixed faces and along a
  /// rough indenter.
  ///
  /// Velocities are up to a factor, and almost without divergence. The force is
  /// what has been minimised; work and errors are not yet computed.
  /// @throws ConvergenceError, UnboundedError if there is no mechanism.
  VelocityField<3>
  find_flux(const SplitBody<3> &body, const double tolerance);
} // namespace ElastoPlastic

#endif
