// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_radial_return_h
#define material_radial_return_h

#include "material/deviatoric_tangent.h"
#include "material/general_return.h"
#include "material/material_state.h"
#include "material/return_equation.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// One backward Euler step of J2 plasticity with isotropic and kinematic
  /// hardening. If both are linear, it is the closed-form radial return
  /// @cite simo_hughes_1998 (box 3.1), on all lanes of a VectorizedArray at
  /// once, with masks in place of branches. If not, or if the flow depends on
  /// its rate, a scalar equation is solved lane by lane (ReturnEquation). The
  /// same with other criteria, with which the return is not radial
  /// (GeneralReturn).
  ///
  /// Everything is deviatoric; the pressure K tr(strain) is the caller's.
  template <typename Number>
  class RadialReturn
  {
  public:
    using Tensor3 = SymmetricTensor<2, 3, Number>;

    /// @p strain is the deviator of the total strain at the end of the step,
    /// @p old_state the state at its beginning, with as many back stresses as
    /// the material. @p material must outlive this object.
    RadialReturn(const Material<Number>      &material,
                 const Tensor3               &strain,
                 const MaterialState<Number> &old_state)
      : material(material)
      , old_state(old_state)
      , elastic_trial_strain(strain - old_state.plastic_strain)
    {
      AssertDimension(material.back_stresses.size(),
                      old_state.back_stresses.size());

      // Step 1: trial stress relative to the centre of the yield surface
      Tensor3 relative_stress =
        2. * material.shear_modulus * elastic_trial_strain;
      for (const Tensor3 &back_stress : old_state.back_stresses)
        relative_stress -= back_stress;
      // (a norm of zero is replaced: the direction then is zero as well)
      norm      = std::max(relative_stress.norm(), Number(1e-100));
      direction = relative_stress / norm;

      // Step 2: the radius; sqrt(2/3) H alpha = 2/3 H sqrt(3/2) alpha
      if (material.is_linear)
        radius = material.yield_radius + material.isotropic_modulus *
                                           std::sqrt(1.5) *
                                           old_state.equivalent_plastic_strain;
      else
        radius = std::sqrt(2. / 3.) *
                 lane_by_lane([](const FlowStress &stress, const unsigned int) {
                   return stress.initial();
                 });

      // Step 3: return to the yield surface along the direction
      modulus    = linear_modulus();
      multiplier = std::max(norm - radius, Number(0.)) / modulus;
      if (!material.is_linear)
        {
          if (has_general_criterion(material))
            return_with_general_criteria(relative_stress);
          else
            return_with_nonlinear_law(relative_stress);
        }
    }

    /// s = 2 G (e - e_p) at the end of the step.
    Tensor3
    deviatoric_stress() const
    {
      return 2. * material.shear_modulus *
             (elastic_trial_strain - plastic_length() * direction);
    }

    /// The incremental potential whose derivative with respect to the strain
    /// is deviatoric_stress() (doc/theory, "Material"). Of materials without
    /// one (has_potential()), this is of no use.
    Number
    energy() const
    {
      Number released = 0.5 * linear_modulus() * multiplier * multiplier;
      if (!material.is_linear)
        released += excess_of_linear_hardening() +
                    lane_by_lane([this](const FlowStress  &stress,
                                        const unsigned int lane) {
                      return stress.complement(
                        lane_of(Number(equivalence * multiplier), lane));
                    });
      return material.shear_modulus *
               (elastic_trial_strain * elastic_trial_strain) -
             relaxation * released;
    }

    /// The flow direction at the end of the step: the relative stress divided
    /// by its norm, or by the radius if the step is elastic.
    Tensor3
    flow_direction() const
    {
      return (norm / std::max(norm, radius)) * direction;
    }

    /// The derivative of deviatoric_stress() with respect to the strain, with
    /// the flow direction left open @cite rudi_shih_stadler_2020. With a
    /// GeneralCriterion, it is one of similar size.
    OpenTangent<Number>
    tangent() const
    {
      const Number two_g = 2. * material.shear_modulus;
      const Number soft  = plastic(relaxation * softness());
      if (material.is_linear)
        {
          const Number scale = std::sqrt(soft);
          return {shear_stiffness(), scale * direction, scale, Tensor3()};
        }
      const Tensor3 turn  = recovery_of_norm();
      const Number  omega = two_g * two_g * plastic_length() / (norm * modulus);
      // (a softness of zero would leave nothing to multiply the rest with)
      const Number scale =
        std::sqrt(plastic(std::max(std::abs(soft), Number(1e-12 * two_g))));
      const Number reciprocal = 1. / std::max(scale, Number(1e-100));
      return {shear_stiffness(),
              scale * direction,
              soft * reciprocal,
              (omega * reciprocal) * (turn - (direction * turn) * direction)};
    }

    /// The derivative of deviatoric_stress() with respect to the strain, with a
    /// GeneralCriterion. It is symmetric, and zero for multiples of the
    /// identity.
    SymmetricTensor<4, 3, Number>
    general_tangent() const;

    /// The flow direction that Newton's method predicts for a strain that is
    /// larger by @p increment, if it takes strain and flow direction as
    /// independent unknowns, and @p flow as the present value of the latter:
    /// from the derivative of norm(z) flow = z, and shortened to 1.
    Tensor3
    predicted_flow(const Tensor3 &flow, const Tensor3 &increment) const
    {
      const Number two_g            = 2. * material.shear_modulus;
      Tensor3      stress_increment = two_g * increment;
      if (!material.is_linear)
        stress_increment += plastic(two_g * (direction * increment) / modulus) *
                            recovery_of_norm();
      const Tensor3 prediction =
        (norm * direction + stress_increment -
         plastic(direction * stress_increment) * flow) /
        std::max(norm, radius);
      return prediction / std::max(prediction.norm(), Number(1.));
    }

    /// The work of the stress on the plastic strain of the step,
    /// s : (e_p - e_p,n).
    Number
    plastic_work() const
    {
      return plastic_length() * (deviatoric_stress() * direction);
    }

    /// G |e - e_p|^2 at the end of the step.
    Number
    distortion_energy() const
    {
      const Tensor3 elastic_strain =
        elastic_trial_strain - plastic_length() * direction;
      return material.shear_modulus * (elastic_strain * elastic_strain);
    }

    /// What hardening has stored at the end of the step:
    /// int_0^alpha (sigma_Y - sigma_0) + sum_k |beta_k|^2 / (2 c_k).
    Number
    hardening_energy() const
    {
      return stored_by_hardening(state());
    }

    /// The dissipation, the part of the plastic work that is not stored: what
    /// hardening has not stored. Not negative (doc/theory, "Load
    /// histories").
    Number
    dissipation() const
    {
      return plastic_work() -
             (hardening_energy() - stored_by_hardening(old_state));
    }

    /// The state at the end of the step.
    MaterialState<Number>
    state() const
    {
      MaterialState<Number> result = old_state;
      result.plastic_strain += plastic_length() * direction;
      result.equivalent_plastic_strain += equivalence * plastic_length();
      // beta + w (theta beta + c l n - beta), and 1 - theta = g l
      for (unsigned int k = 0; k < result.back_stresses.size(); ++k)
        {
          const auto &law         = material.back_stresses[k];
          Tensor3    &back_stress = result.back_stresses[k];
          back_stress += (relaxation * law.length(multiplier)) *
                         (law.modulus * direction - law.recovery * back_stress);
        }
      return result;
    }

    /// @p value on the lanes that yield, zero on the others.
    Number
    plastic(const Number &value) const
    {
      return compare_and_apply_mask<SIMDComparison::greater_than>(multiplier,
                                                                  Number(0.),
                                                                  value,
                                                                  Number(0.));
    }

  private:
    /// 2 G + 2/3 H + sum_k c_k
    Number
    linear_modulus() const
    {
      Number sum = 2. * material.shear_modulus + material.isotropic_modulus;
      for (const auto &law : material.back_stresses)
        sum += law.modulus;
      return sum;
    }

    /// The length of the plastic strain increment.
    Number
    plastic_length() const
    {
      return relaxation * multiplier;
    }

    /// 2 G theta: the stiffness against shear across the flow direction.
    Number
    shear_stiffness() const
    {
      const Number two_g = 2. * material.shear_modulus;
      return two_g * (1. - two_g * plastic_length() / norm);
    }

    /// 2 G theta_bar, on lanes that yield: by how much the stiffness along the
    /// flow direction is smaller.
    Number
    softness() const
    {
      const Number two_g = 2. * material.shear_modulus;
      return two_g * (two_g / modulus - two_g * multiplier / norm);
    }

    /// dz/d(multiplier) = sum_k theta_k g_k beta_k,n
    Tensor3
    recovery_of_norm() const
    {
      Tensor3 sum;
      for (unsigned int k = 0; k < old_state.back_stresses.size(); ++k)
        {
          const auto &law = material.back_stresses[k];
          sum += (law.remainder(multiplier) * law.recovery) *
                 old_state.back_stresses[k];
        }
      return sum;
    }

    /// What @p function makes of the flow stress of each lane.
    template <typename Function>
    Number
    lane_by_lane(const Function &function) const
    {
      Number result;
      for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
        lane_of(result, lane) = function(
          FlowStress(material, old_state.equivalent_plastic_strain, lane),
          lane);
      return result;
    }

    /// Step 3 for the general law: the multiplier, and what depends on it.
    void
    return_with_nonlinear_law(const Tensor3 &trial)
    {
      solve_return_equations(trial);

      Tensor3 relative_stress = trial;
      for (unsigned int k = 0; k < old_state.back_stresses.size(); ++k)
        {
          const auto &law = material.back_stresses[k];
          relative_stress += (law.recovery * law.length(multiplier)) *
                             old_state.back_stresses[k];
        }
      norm      = std::max(relative_stress.norm(), Number(1e-100));
      direction = relative_stress / norm;

      modulus = 2. * material.shear_modulus - direction * recovery_of_norm() +
                2. / 3. *
                  lane_by_lane(
                    [this](const FlowStress &stress, const unsigned int lane) {
                      const double x = lane_of(multiplier, lane);
                      return x > 0. ? stress.slope(std::sqrt(2. / 3.) * x) : 0.;
                    });
      for (unsigned int k = 0; k < old_state.back_stresses.size(); ++k)
        {
          const auto &law = material.back_stresses[k];
          modulus += law.remainder(multiplier) * law.modulus;
        }

      for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
        lane_of(relaxation, lane) =
          material.rate_laws[lane].relaxation(material.step_duration);
    }

    void
    solve_return_equations(const Tensor3 &trial);

    /// Step 3 with a GeneralCriterion in each lane: multiplier and direction,
    /// and what depends on them.
    void
    return_with_general_criteria(const Tensor3 &trial);

    /// 2 G + sum_k c_k
    Number
    kinematic_modulus() const
    {
      return linear_modulus() - material.isotropic_modulus;
    }

    /// With a GeneralCriterion, by how much H x^2 / 2, x being the growth of
    /// alpha, exceeds what it would be with the criterion of von Mises.
    Number
    excess_of_linear_hardening() const
    {
      if (!has_general_criterion(material))
        return Number(0.);
      return 0.5 * material.isotropic_modulus *
             (1.5 * equivalence * equivalence - 1.) * multiplier * multiplier;
    }

    Number
    stored_by_hardening(const MaterialState<Number> &state) const
    {
      const Number alpha = state.equivalent_plastic_strain;
      Number       sum   = 0.75 * material.isotropic_modulus * alpha * alpha;
      for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
        if (const HardeningCurve *curve = material.curves[lane].get())
          lane_of(sum, lane) += curve->integral(lane_of(alpha, lane));
      // (where the modulus is zero, there is no back stress)
      for (unsigned int k = 0; k < state.back_stresses.size(); ++k)
        sum += 0.5 * (state.back_stresses[k] * state.back_stresses[k]) /
               std::max(material.back_stresses[k].modulus, Number(1e-100));
      return sum;
    }

    const Material<Number>     &material;
    const MaterialState<Number> old_state;

    const Tensor3 elastic_trial_strain;
    /// The relative stress z, from which the return is radial: xi, the trial
    /// stress less the old back stresses, plus what these lose in the step by
    /// recovery.
    Number  norm;
    Tensor3 direction;
    /// At the beginning of the step.
    Number radius;
    /// What the excess of the stress over the yield surface falls by per unit
    /// of the multiplier.
    Number modulus;
    /// Delta lambda: how long the plastic strain increment is, or without
    /// relaxation would be.
    Number multiplier;
    /// See RateLaw.
    Number relaxation = Number(1.);
    /// How much alpha grows per length of the plastic strain.
    Number equivalence = Number(std::sqrt(2. / 3.));
  };
} // namespace ElastoPlastic

#include "material/radial_return.templates.h"

#endif
