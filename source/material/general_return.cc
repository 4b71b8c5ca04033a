// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "material/general_return.h"
#include "material/positive_root.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The same for all criteria: @p use is called with their Relaxation of
    /// @p trial.
    template <typename Use>
    auto
    with_relaxation(const GeneralCriterion      &criterion,
                    const SymmetricTensor<2, 3> &trial,
                    const Use                   &use)
    {
      return std::visit(
        [&](const auto &of_type) {
          return use(
            typename std::decay_t<decltype(of_type)>::Relaxation(of_type,
                                                                 trial));
        },
        criterion);
    }
  } // namespace



  // (Of all these criteria, |n|^2 is about 3/2: that bounds x.)
  GeneralReturn::Flow
  GeneralReturn::flow() const
  {
    return with_relaxation(criterion, trial, [this](auto relaxation) -> Flow {
      const double excess =
        relaxation.equivalent_stress() - flow_stress.initial();
      if (!(excess > 0.) || !flow_stress.can_flow())
        return {};
      const auto remaining_excess = [&](const double unknown) {
        const auto flow = flow_stress.at(unknown);
        relaxation.set_ratio(modulus * flow.increment / flow.stress);
        return relaxation.equivalent_stress() - flow.stress;
      };
      const double unknown =
        positive_root(remaining_excess,
                      excess,
                      flow_stress.unknown(excess / (1.5 * modulus)));
      remaining_excess(unknown);
      return {flow_stress.at(unknown).increment, relaxation.normal()};
    });
  }



  // From (1 + t d(q n)/dz) dz = dxi - q n dt with D = (1 + t d(q n)/dz)^-1,
  // n : dz = sigma' dx and dt = M (1 - x sigma' / sigma) / sigma dx.
  SymmetricTensor<4, 3>
  GeneralReturn::derivative(const double increment) const
  {
    return with_relaxation(criterion, trial, [&](auto relaxation) {
      const double stress =
        flow_stress.at(flow_stress.unknown(increment)).stress;
      const double slope = flow_stress.slope(increment);
      relaxation.set_ratio(modulus * increment / stress);
      const SymmetricTensor<4, 3> derivative = relaxation.derivative();
      const SymmetricTensor<2, 3> normal     = relaxation.normal();
      const SymmetricTensor<2, 3> across     = derivative * normal;
      const double softening = modulus * (1. - increment * slope / stress);
      return derivative - softening / (slope + softening * (normal * across)) *
                            outer_product(across, across);
    });
  }
} // namespace ElastoPlastic
