// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_limit_load_h
#define bounds_limit_load_h

#include <vector>

#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/velocity_program.h"
#include "bounds/stress/stress_field.h"

namespace ElastoPlastic
{
  /// Two bounds of the largest force, or the largest load factor, that a body
  /// of perfectly plastic materials can bear: any force below that of the
  /// stresses is safe, J (1.14) in
  /// @cite johnson_1978, any force above that of the mechanism is not.
  template <int dim>
  struct LimitLoad
  {
    StressField<dim>   stress;
    VelocityField<dim> velocity;
    /// What the velocities are those of: see circumscribe().
    SplitBody<dim> body_of_velocity;

    /// Forces of the indenter, or load factors if other loads grow.
    double lower_bound = 0;
    double upper_bound = 0;

    /// By simplices, with a share of what is on their faces: plastic work of
    /// the mechanism less the power of the stresses,
    /// int sqrt(2/3) sigma_0 |e(v)| - tau : e(v) dx, or that of a soil. It is
    /// never negative, and zero where the two fields belong together; all
    /// together are the difference of the bounds at most, or that by the power
    /// of the loads that grow. (Beside the edge of a disc, where both have
    /// meshes of their own, they are indicators.)
    std::vector<double> gaps;
  };



  /// What is known of the multipliers of both programs, by simplices, from the
  /// bounds on a coarser mesh: with it, the solver takes fewer iterations.
  struct ExpectedMultipliers
  {
    std::vector<double> of_stress;
    std::vector<double> of_velocity;
  };

  /// From @p bounds on the mesh of @p last, those on the @p next one.
  template <int dim>
  ExpectedMultipliers
  expected_multipliers(const LimitLoad<dim> &bounds,
                       const SplitMesh<dim> &last,
                       const SplitMesh<dim> &next);

  /// @param degree of the stresses, see maximize_load().
  /// @throws ConvergenceError
  template <int dim>
  LimitLoad<dim>
  bound_limit_load(const SplitBody<dim> &body,
                   const unsigned int    degree,
                   const double tolerance = Tolerance::gap_of_bounds<dim>,
                   const ExpectedMultipliers &expected = {});
} // namespace ElastoPlastic

#endif
