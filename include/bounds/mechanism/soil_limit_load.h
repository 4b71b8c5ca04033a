// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_soil_limit_load_h
#define bounds_mechanism_soil_limit_load_h

#include "bounds/conic/friction.h"
#include "bounds/mechanism/velocity_check.h"
#include "bounds/stress/stress_check.h"

namespace ElastoPlastic
{
  /// The errors of stresses as for metals, but for the yield condition, which
  /// is that of the soil, at all coefficients of the stresses.
  StressErrors
  check_stress_of_soil(const SplitBody<2>   &body,
                       const FrictionSines  &sines,
                       const StressField<2> &field);

  /// The errors of velocities, which must be continuous; `divergence` is what
  /// the rate of volume lacks to sin phi |(e_11 - e_22, 2 e_12)|, times the
  /// size of the triangle. Both hold at all points if they do for the
  /// coefficients of the strain rate in Bernstein's basis.
  VelocityErrors
  check_velocity_of_soil(const SplitBody<2>                    &body,
                         const FrictionSines                   &sines,
                         const std::vector<SimplexVelocity<2>> &velocity);

  /// By triangles: c cot phi int div v dx, or without friction an upper bound
  /// of int c |(e_11 - e_22, 2 e_12)| dx.
  std::vector<double>
  plastic_work_of_soil(const SplitBody<2>                    &body,
                       const FrictionSines                   &sines,
                       const std::vector<SimplexVelocity<2>> &velocity);

  /// The mechanism of least plastic work, less the power of constant loads,
  /// among continuous piecewise quadratic velocities, that moves the indenter
  /// down by one; with its work and errors.
  /// @throws ConvergenceError, UnboundedError
  VelocityField<2>
  minimize_plastic_work_of_soil(const SplitBody<2>  &body,
                                const FrictionSines &sines,
                                const double         tolerance);
} // namespace ElastoPlastic

#endif
