// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_continuous_velocities_h
#define bounds_mechanism_continuous_velocities_h

#include <memory>
#include <vector>

#include "bounds/mechanism/velocity_field.h"

namespace ElastoPlastic
{
  /// One of the functions that velocities are combined of, on a triangle.
  struct VelocityFunction
  {
    unsigned int       number; ///< among those of the whole body
    SimplexVelocity<2> velocity;
  };

  /// A basis of continuous velocities that may change the volume. They are zero
  /// in the directions in which the body is held, and along a rough indenter
  /// where it reaches.
  ///
  /// In the plane, they are quadratic on each triangle, and the strain rate is
  /// linear. In a body of revolution, v_r = (r / L) w with a quadratic w and
  /// the length unit L, and v_z is cubic. So the rates e_rr = (w + r d_r w) /
  /// L, e_tt = w / L, e_zz = d_z v_z and 2 e_rz = r d_z w / L + d_r v_z are
  /// quadratic polynomials, and those without a change of volume, v_r = -r d_z
  /// chi and v_z = 2 chi + r d_r chi with a cubic chi, are among them: so
  /// they are not lost as the angle of friction tends to zero.
  class ContinuousVelocities
  {
  public:
    virtual ~ContinuousVelocities() = default;

    /// On the whole body.
    virtual unsigned int
    n_functions() const = 0;

    /// Those that do not vanish on a @p triangle.
    virtual std::vector<VelocityFunction>
    functions_of(const unsigned int triangle) const = 0;

    /// Of the strain rate as a polynomial on a triangle.
    const unsigned int rate_degree;
    /// Of the vertical velocity as a polynomial on a side.
    const unsigned int trace_degree;

  protected:
    ContinuousVelocities(const unsigned int rate_degree,
                         const unsigned int trace_degree)
      : rate_degree(rate_degree)
      , trace_degree(trace_degree)
    {}
  };



  /// Those of a @p body, which must live as long as the result.
  std::unique_ptr<ContinuousVelocities>
  make_continuous_velocities(const SplitBody<2> &body);
} // namespace ElastoPlastic

#endif
