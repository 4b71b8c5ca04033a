// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_material_h
#define material_material_h

#include <deal.II/base/point.h>

#include <boost/container/static_vector.hpp>

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <variant>

#include "base/simd.h"
#include "material/hardening_curve.h"
#include "material/hill.h"
#include "material/hosford.h"
#include "material/rate_law.h"

namespace ElastoPlastic
{
  /// The criteria for which the return to the yield surface is not radial: q(z)
  /// <= sigma with another norm q of the relative stress z than that of von
  /// Mises. What they have in common is what GeneralReturn asks of them, point
  /// by point: principal axes and powers are nothing for batches.
  using GeneralCriterion = std::variant<HillCriterion, HosfordCriterion>;



  /// So many back stresses may a material have.
  constexpr unsigned int max_back_stresses = 4;



  /// The evolution of a back stress, with the plastic strain e_p and the
  /// plastic multiplier lambda: beta' = modulus e_p' - recovery beta
  /// lambda', the last term being the dynamic recovery
  /// @cite armstrong_frederick_1966.
  template <typename Number>
  struct BackStressLaw
  {
    /// c = 2/3 C, unit: stress. It is positive where recovery is.
    Number modulus;
    /// g = sqrt(2/3) gamma; without it, this is Prager's rule.
    Number recovery;

    /// exp(-g x): what recovery leaves of a back stress beta while lambda grows
    /// by x.
    Number
    remainder(const Number &x) const;

    /// (1 - exp(-g x)) / g, or x without recovery: times c n, what a flow of
    /// the length x in the direction n adds meanwhile. Both together solve the
    /// law exactly as long as n is constant, remainder(x) beta + c length(x) n.
    Number
    length(const Number &x) const;
  };



  template <typename Number>
  Number
  BackStressLaw<Number>::remainder(const Number &x) const
  {
    return 1. - recovery * length(x);
  }



  template <typename Number>
  Number
  BackStressLaw<Number>::length(const Number &x) const
  {
    Number result = x;
    for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
      if (const double g = lane_of(recovery, lane); g > 0)
        lane_of(result, lane) = -std::expm1(-g * lane_of(x, lane)) / g;
    return result;
  }



  /// The constants of an elasto-plastic material, isotropic as long as it is
  /// elastic, in the form the radial return needs them. Its yield stress is
  /// sigma_0 + H alpha + h(alpha), alpha being the equivalent plastic strain;
  /// its back stress is the sum of several. @p Number is double, or a
  /// VectorizedArray when the cells of a batch consist of different materials.
  template <typename Number>
  struct Material
  {
    /// K = E / (3 (1 - 2 nu))
    Number bulk_modulus;
    /// G = E / (2 (1 + nu))
    Number shear_modulus;
    /// sqrt(2/3) sigma_0, the radius of the virgin yield surface in the space
    /// of deviatoric stresses; infinite for an elastic material.
    Number yield_radius;
    /// 2/3 H: what the radius gains per unit of the plastic multiplier.
    Number isotropic_modulus;

    boost::container::static_vector<BackStressLaw<Number>, max_back_stresses>
      back_stresses;

    /// h, of each lane; none if it is zero.
    std::array<std::shared_ptr<const HardeningCurve>, n_lanes<Number>> curves;

    /// Of each lane; none in any of them if that of von Mises holds for all
    /// materials of the body.
    std::array<std::shared_ptr<const GeneralCriterion>, n_lanes<Number>>
      criteria;

    /// Where the criterion depends on the position, what it is at a point, in
    /// two dimensions with z = 0; then @p criteria is an example. Batches have
    /// none, but a material for each point (BatchMaterials).
    std::function<GeneralCriterion(const Point<3> &)> criterion_at;

    /// Of each lane.
    std::array<RateLaw, n_lanes<Number>> rate_laws;

    /// How long the load step under way takes. Only rate laws read it.
    double step_duration = 0;

    /// Whether there is neither h nor recovery nor rate dependence, nor a
    /// GeneralCriterion: the return to the yield surface then is a formula.
    bool is_linear = true;
  };



  /// Whether the material resists changes of volume so much (nu > 0.452) that
  /// linear systems take fewer steps in the mixed form (SolidOperator).
  inline bool
  is_nearly_incompressible(const Material<double> &material)
  {
    return material.bulk_modulus > 10. * material.shear_modulus;
  }



  inline bool
  has_recovery(const Material<double> &material)
  {
    for (const auto &law : material.back_stresses)
      if (law.recovery > 0)
        return true;
    return false;
  }



  template <typename Number>
  bool
  has_general_criterion(const Material<Number> &material)
  {
    return material.criteria[0] != nullptr;
  }



  inline bool
  has_varying_criterion(const Material<double> &material)
  {
    return static_cast<bool>(material.criterion_at);
  }



  inline bool
  is_rate_dependent(const Material<double> &material)
  {
    return material.rate_laws[0].type != RateLawType::none;
  }



  /// Whether the stress has an incremental potential.
  inline bool
  has_potential(const Material<double> &material)
  {
    const RateLawType type = material.rate_laws[0].type;
    const bool        yields =
      material.yield_radius < std::numeric_limits<double>::infinity();
    return !has_recovery(material) && type != RateLawType::cowper_symonds &&
           !(type == RateLawType::norton && yields);
  }



  /// Whether the material cannot carry more than a certain shear stress: a body
  /// of it has a limit load.
  inline bool
  has_limit(const Material<double> &material)
  {
    for (const auto &law : material.back_stresses)
      if (law.modulus > 0 && law.recovery == 0)
        return false;
    return material.yield_radius < std::numeric_limits<double>::infinity() &&
           !is_rate_dependent(material) && material.isotropic_modulus == 0 &&
           (!material.curves[0] || material.curves[0]->is_bounded());
  }



  /// Whether there is nothing but a yield stress: neither hardening nor rate
  /// dependence.
  inline bool
  is_perfect(const Material<double> &material)
  {
    return material.isotropic_modulus == 0 && material.back_stresses.empty() &&
           !material.curves[0] && !is_rate_dependent(material);
  }



  /// Puts the materials @p of_lane together, with @p n_back_stresses back
  /// stresses, as many as the richest of them has, or more.
  template <typename Number>
  Material<Number>
  join_lanes(
    const std::array<const Material<double> *, n_lanes<Number>> &of_lane,
    const unsigned int n_back_stresses)
  {
    Material<Number> result;
    result.back_stresses.resize(n_back_stresses, {Number(0.), Number(0.)});
    for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
      {
        const Material<double> &material        = *of_lane[lane];
        lane_of(result.bulk_modulus, lane)      = material.bulk_modulus;
        lane_of(result.shear_modulus, lane)     = material.shear_modulus;
        lane_of(result.yield_radius, lane)      = material.yield_radius;
        lane_of(result.isotropic_modulus, lane) = material.isotropic_modulus;
        for (unsigned int k = 0; k < material.back_stresses.size(); ++k)
          {
            const auto &[modulus, recovery] = material.back_stresses[k];
            lane_of(result.back_stresses[k].modulus, lane)  = modulus;
            lane_of(result.back_stresses[k].recovery, lane) = recovery;
          }
        result.curves[lane]    = material.curves[0];
        result.criteria[lane]  = material.criteria[0];
        result.rate_laws[lane] = material.rate_laws[0];
        result.step_duration   = material.step_duration;
        result.is_linear       = result.is_linear && material.is_linear;
      }
    return result;
  }



  /// The material of one lane.
  template <typename Number>
  Material<double>
  lane_of(const Material<Number> &material, const unsigned int lane)
  {
    Material<double> result;
    result.bulk_modulus      = lane_of(material.bulk_modulus, lane);
    result.shear_modulus     = lane_of(material.shear_modulus, lane);
    result.yield_radius      = lane_of(material.yield_radius, lane);
    result.isotropic_modulus = lane_of(material.isotropic_modulus, lane);
    for (const auto &[modulus, recovery] : material.back_stresses)
      result.back_stresses.push_back(
        {lane_of(modulus, lane), lane_of(recovery, lane)});
    result.curves[0]     = material.curves[lane];
    result.criteria[0]   = material.criteria[lane];
    result.rate_laws[0]  = material.rate_laws[lane];
    result.step_duration = material.step_duration;
    result.is_linear     = material.is_linear;
    return result;
  }
} // namespace ElastoPlastic

#endif
