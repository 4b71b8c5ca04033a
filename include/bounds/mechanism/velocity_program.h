// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_velocity_program_h
#define bounds_mechanism_velocity_program_h

#include "bounds/body/evaluated_bounds.h"
#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  /// The mechanism that takes least plastic work among velocities that are zero
  /// at the supports and go down by 1 or more everywhere under the indenter
  /// (stream_program.h, sheet_program.h, in space flux_program.h). By the
  /// kinematic theorem, its work int sqrt(2/3) sigma_0 |e(v)| dx is an upper
  /// bound of the limit load @cite hill_1950. The bound follows from the
  /// velocities alone, by velocity_check.h.
  /// @param tolerance of the best bound of the mesh, relative
  /// @throws ConvergenceError, in particular if there is no mechanism.
  template <int dim>
  VelocityField<dim>
  minimize_plastic_work(const SplitBody<dim> &body,
                        const double          tolerance = usual_tolerance<dim>);
} // namespace ElastoPlastic

#endif
