// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_general_return_h
#define material_general_return_h

#include "material/flow_stress.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// One backward Euler step at a point, to the yield surface q(z) = sigma of a
  /// GeneralCriterion: find the relative stress z and the equivalent plastic
  /// strain x > 0 of the step with
  ///
  ///   z + M x n(z) = xi,   q(z) = sigma(x),   n = dq/dz,
  ///
  /// where xi is the trial stress relative to the old back stresses, M = 2 G +
  /// sum_k c_k, and sigma the FlowStress (doc/theory, "Yield criteria"). With
  /// the ratio t = M x / sigma(x), z is that of Relaxation::set_ratio(); so a
  /// scalar equation remains. As q falls with x and sigma does not, there is
  /// one solution.
  struct GeneralReturn
  {
    /// All arguments must outlive this object; M is @p modulus.
    GeneralReturn(const GeneralCriterion      &criterion,
                  const SymmetricTensor<2, 3> &trial,
                  const double                 modulus,
                  const FlowStress            &flow_stress)
      : criterion(criterion)
      , trial(trial)
      , modulus(modulus)
      , flow_stress(flow_stress)
    {}


    /// x and n; both zero if the trial stress lies inside the yield surface.
    /// Not a number if there is no solution, as for data that are none.
    struct Flow
    {
      double                increment = 0;
      SymmetricTensor<2, 3> normal;
    };

    Flow
    flow() const;

    /// dz/dxi, of deviators, with the @p increment of the flow; zero for
    /// multiples of the identity. It is symmetric.
    SymmetricTensor<4, 3>
    derivative(const double increment) const;

  private:
    const GeneralCriterion      &criterion;
    const SymmetricTensor<2, 3> &trial;
    const double                 modulus;
    const FlowStress            &flow_stress;
  };
} // namespace ElastoPlastic

#endif
