// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_flow_resistance_h
#define material_flow_resistance_h

#include "material/flow_stress.h"

namespace ElastoPlastic
{
  /// What the norm of the relative stress, the z of the return to the yield
  /// surface, must be at the end of a backward Euler step in which the plastic
  /// multiplier is x (doc/theory, "Material"):
  ///
  ///   R(x) = 2 G x + sum_k c_k l_k(x) + sqrt(2/3) sigma(sqrt(2/3) x),
  ///
  /// with the BackStressLaw's length l_k and the FlowStress sigma. It grows by
  /// 2 G per unit of x or faster. The unknown is that of the FlowStress.
  class FlowResistance
  {
  public:
    /// The one of a lane of @p material, whose point begins the step with the
    /// equivalent plastic strain @p alpha. @p material must outlive this
    /// object.
    template <typename Number>
    FlowResistance(const Material<Number> &material,
                   const Number           &alpha,
                   const unsigned int      lane);

    /// All that belongs to a value of the unknown: the multiplier x, R, and
    /// their derivatives with respect to the unknown.
    struct Value
    {
      double multiplier, resistance, multiplier_slope, slope;
    };

    Value
    at(const double unknown) const;

    /// Its unknown is not smaller than the solution if the norm of z exceeds
    /// R(0) by @p excess, and less where x > 0.
    double
    upper_bound(const double excess) const;

    /// The back stresses' moduli and rates of recovery.
    boost::container::static_vector<BackStressLaw<double>, max_back_stresses>
      back_stresses;

    /// 2 G
    double elastic_modulus;

    FlowStress flow_stress;
  };



  template <typename Number>
  FlowResistance::FlowResistance(const Material<Number> &material,
                                 const Number           &alpha,
                                 const unsigned int      lane)
    : elastic_modulus(2. * lane_of(material.shear_modulus, lane))
    , flow_stress(material, alpha, lane)
  {
    for (const auto &[modulus, recovery] : material.back_stresses)
      back_stresses.push_back(
        {lane_of(modulus, lane), lane_of(recovery, lane)});
  }
} // namespace ElastoPlastic

#endif
