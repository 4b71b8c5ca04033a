// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_return_equation_h
#define material_return_equation_h

#include <array>

#include "material/flow_stress.h"

namespace ElastoPlastic
{
  /// The scalar equation that a backward Euler step of a nonlinear law leads
  /// to, at one point: find the plastic multiplier x > 0 for which the relative
  /// stress is what flow takes (doc/theory, "Material"),
  ///
  ///   |z(x)| - R(x) = 0,   z(x) = xi + sum_k (1 - theta_k) beta_k,
  ///
  /// where xi is the trial stress relative to the old back stresses beta_k,
  /// theta_k what the BackStressLaw leaves of them, and
  /// R the FlowResistance. The left side decreases, by 2 G per unit of x or
  /// faster, as long as no |beta_k| exceeds c_k / g_k.
  struct ReturnEquation
  {
    FlowResistance resistance;

    /// The scalar products of the tensors xi, beta_1, beta_2, ...
    std::array<std::array<double, max_back_stresses + 1>, max_back_stresses + 1>
      products;

    struct Value
    {
      double excess; ///< the left side
      double slope;  ///< its derivative
      double norm;   ///< |z|
    };

    /// At a value of the unknown of the FlowStress.
    Value
    evaluate(const double unknown) const;

    /// A solution x, up to rounding; 0 if the trial stress lies inside the
    /// yield surface. Newton's method between bounds that enclose the solution;
    /// if a back stress is too large for the left side to be monotone, a
    /// bracketing method without slopes. Not a number if there is no solution,
    /// as for data that are none: forces and energy are none either then, and
    /// all ranks notice.
    double
    solve() const;

  private:
    /// Whether no back stress exceeds c / g, but for rounding.
    bool
    is_monotone() const;

    /// The unknown if the left side is monotone, and @p at_zero where x = 0.
    double
    newton_iteration(const Value &at_zero) const;
  };
} // namespace ElastoPlastic

#endif
