// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_flow_stress_h
#define material_flow_stress_h

#include <cmath>

#include "material/material.h"

namespace ElastoPlastic
{
  /// The stress in tension at which a point flows in a backward Euler step, by
  /// how much its equivalent plastic strain grows in the step: the yield
  /// stress
  ///
  ///   sigma_Y(alpha_n + increment)
  ///
  /// and, of materials with a RateLaw, what the rate increment / duration makes
  /// of it. It does not decrease.
  ///
  /// With rate dependence its slope is infinite where the increment is zero.
  /// Equations that are to be solved for the increment are smooth functions of
  /// another unknown, the overstress ratio y:
  ///
  ///   increment = reference_rate duration y^n.
  ///
  /// Without rate dependence the unknown is the increment.
  class FlowStress
  {
  public:
    /// The one of a lane of @p material, whose point begins the step with the
    /// equivalent plastic strain @p alpha. @p material must outlive this
    /// object.
    template <typename Number>
    FlowStress(const Material<Number> &material,
               const Number           &alpha,
               const unsigned int      lane);

    /// Where flow begins.
    double
    initial() const
    {
      return rate_law.flow_stress(yield_stress(0.), 0.).stress;
    }

    /// The derivative with respect to the @p increment > 0.
    double
    slope(const double increment) const;

    /// stress(increment) increment - int_0^increment stress, but for what
    /// comes of linear hardening. (Of rate laws that have a potential.)
    double
    complement(const double increment) const;

    /// All that belongs to a value of the unknown: the increment, the stress
    /// and their derivatives with respect to the unknown.
    struct Value
    {
      double increment, stress, increment_slope, stress_slope;
    };

    Value
    at(const double unknown) const;

    /// The unknown that belongs to an @p increment.
    double
    unknown(const double increment) const
    {
      return exponent == 1. ?
               increment / increment_of_one :
               std::pow(increment / increment_of_one, 1. / exponent);
    }

    /// Whether there is time to flow.
    bool
    can_flow() const
    {
      return increment_of_one > 0.;
    }

  private:
    double
    yield_stress(const double increment) const;

    double
    yield_slope(const double increment) const
    {
      return linear_modulus + (curve ? curve->slope(alpha + increment) : 0.);
    }

    /// sigma_0 and H, unit: stress
    const double initial_yield_stress, linear_modulus;
    /// May be a null pointer.
    const HardeningCurve *const curve;
    const RateLaw              &rate_law;
    const double                alpha;

    /// n, and the increment that belongs to the unknown 1.
    const double exponent, increment_of_one;
  };



  template <typename Number>
  FlowStress::FlowStress(const Material<Number> &material,
                         const Number           &alpha,
                         const unsigned int      lane)
    : initial_yield_stress(std::sqrt(1.5) *
                           lane_of(material.yield_radius, lane))
    , linear_modulus(1.5 * lane_of(material.isotropic_modulus, lane))
    , curve(material.curves[lane].get())
    , rate_law(material.rate_laws[lane])
    , alpha(lane_of(alpha, lane))
    , exponent(rate_law.has_ratio() ? rate_law.exponent : 1.)
    , increment_of_one(rate_law.has_ratio() ?
                         rate_law.reference_rate * material.step_duration :
                         1.)
  {}



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
