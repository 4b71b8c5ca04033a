// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_stress_check_h
#define bounds_stress_stress_check_h

#include "bounds/stress/stress_field.h"

namespace ElastoPlastic
{
  /// How well a stress field satisfies what it promises, relative to the unit
  /// of stress of the body, SplitBody::stress_unit: all should be zero but for
  /// rounding. Errors of weighted stresses are divided by the distance from the
  /// axis of a body of revolution. On the axis, where these stresses must
  /// vanish, all follows from that.
  struct StressErrors
  {
    /// What is missing to equilibrium, times the size of the simplex.
    double divergence = 0;
    double on_axis    = 0; ///< weighted stress, over the size of the triangle
    /// The component 33 against the circumferential stress times r.
    double circumferential = 0;
    double out_of_plane    = 0; ///< the component 33 of a sheet
    double traction_jump   = 0; ///< between parts and between simplices
    double boundary_force =
      0;                ///< given tractions, and shear under the indenter
    double tension = 0; ///< under the indenter
    /// Where the material does not harden: stress_norm() less the yield radius
    /// R, over R. That of soil is the one at the point, R - sqrt(2) f m, but
    /// under tension that without pressure: so much more cohesion and friction
    /// would bear the stress. (The unit of stress would not do: on heavy
    /// ground, it is the strength at the bottom.)
    double yield_excess = 0;
    double force_difference =
      0; ///< of the field's force and int p ds, relative

    double
    largest() const;
  };



  /// Looks at every part of a simplex and every face of the mesh, using nothing
  /// but the stresses themselves.
  template <int dim>
  StressErrors
  check_stress(const SplitBody<dim> &body, const StressField<dim> &field);

  /// The largest error that check_stress() finds, which must not be more than
  /// rounding. @throws ConvergenceError if it is: nothing follows from such
  /// stresses.
  template <int dim>
  double
  require_admissible(const SplitBody<dim> &body, const StressField<dim> &field);
} // namespace ElastoPlastic

#endif
