// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_radial_return_h
#define material_radial_return_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/vectorization.h>

#include <array>

#include "base/tensors.h"
#include "material/material.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What a material point remembers of its past. Tensors are deviatoric and
  /// three-dimensional, also in plane problems.
  template <typename Number>
  struct MaterialState
  {
    SymmetricTensor<2, 3, Number> plastic_strain;
    SymmetricTensor<2, 3, Number> back_stress;
    /// alpha, with the rate sqrt(2/3) |plastic strain rate|.
    Number equivalent_plastic_strain = Number(0.);

    /// All numbers that a state consists of, for storage.
    static constexpr unsigned int n_numbers = 13;

    std::array<Number *, n_numbers>
    numbers()
    {
      std::array<Number *, n_numbers> result;
      for (unsigned int i = 0; i < 6; ++i)
        {
          result[i]     = &plastic_strain.access_raw_entry(i);
          result[6 + i] = &back_stress.access_raw_entry(i);
        }
      result[12] = &equivalent_plastic_strain;
      return result;
    }
  };



  /// The deviatoric part of a tangent, de -> a de - (m (l : de) + l (m : de))/2
  /// with a = 2 G theta, where m and l are the normal of the yield surface and
  /// the flow direction, both times sqrt(2 G theta_bar); for the consistent
  /// tangent they are the same (doc/theory.md, "Material"). Since both are
  /// deviatoric, their in-plane parts (dim = 2) say all about them.
  template <int dim, typename Number>
  struct DeviatoricTangent
  {
    Number                          shear = Number(0.);
    SymmetricTensor<2, dim, Number> normal;
    SymmetricTensor<2, dim, Number> flow;

    /// The deviatoric stress increment that belongs to the increment @p strain.
    DEAL_II_ALWAYS_INLINE SymmetricTensor<2, 3, Number>
    operator*(const SymmetricTensor<2, 3, Number> &strain) const
    {
      const auto m = in_space<dim>(normal, Number(-trace(normal)));
      const auto l = in_space<dim>(flow, Number(-trace(flow)));

      const Number                  mean   = shear * trace(strain) * (1. / 3.);
      SymmetricTensor<2, 3, Number> stress = shear * strain;
      stress -= (0.5 * (l * strain)) * m;
      stress -= (0.5 * (m * strain)) * l;
      for (unsigned int d = 0; d < 3; ++d)
        stress[d][d] -= mean;
      return stress;
    }
  };



  /// One backward Euler step of J2 plasticity with linear isotropic and
  /// kinematic hardening: the closed-form radial return
  /// @cite simo_hughes_1998 (box 3.1). Works on all lanes of a
  /// VectorizedArray at once, with masks in place of branches.
  ///
  /// Everything is deviatoric; the pressure K tr(strain) is the caller's.
  template <typename Number>
  class RadialReturn
  {
  public:
    using Tensor3 = SymmetricTensor<2, 3, Number>;

    /// @p strain is the deviator of the total strain at the end of the step,
    /// @p old_state the state at its beginning.
    RadialReturn(const Material<Number>      &material,
                 const Tensor3               &strain,
                 const MaterialState<Number> &old_state)
      : material(material)
      , old_state(old_state)
      , modulus(2. * material.shear_modulus + material.isotropic_modulus +
                material.kinematic_modulus)
      , elastic_trial_strain(strain - old_state.plastic_strain)
    {
      // Step 1: trial stress relative to the centre of the yield surface
      const Tensor3 relative_stress =
        2. * material.shear_modulus * elastic_trial_strain -
        old_state.back_stress;
      // (a norm of zero is replaced: the direction then is zero as well)
      trial_norm = std::max(relative_stress.norm(), Number(1e-100));
      direction  = relative_stress / trial_norm;

      // Step 2: the radius; sqrt(2/3) H alpha = 2/3 H sqrt(3/2) alpha
      radius = material.yield_radius + material.isotropic_modulus *
                                         std::sqrt(1.5) *
                                         old_state.equivalent_plastic_strain;

      // Step 3: return to the yield surface along the direction
      multiplier = std::max(trial_norm - radius, Number(0.)) / modulus;
    }

    /// s = 2 G (e - e_p) at the end of the step.
    Tensor3
    deviatoric_stress() const
    {
      return 2. * material.shear_modulus *
             (elastic_trial_strain - multiplier * direction);
    }

    /// The incremental potential whose derivative with respect to the strain
    /// is deviatoric_stress(): G |e - e_p,n|^2 - (multiplier)^2 modulus / 2.
    Number
    energy() const
    {
      return material.shear_modulus *
               (elastic_trial_strain * elastic_trial_strain) -
             0.5 * modulus * multiplier * multiplier;
    }

    /// The flow direction at the end of the step: the relative stress divided
    /// by its norm, or by the radius if the step is elastic.
    Tensor3
    flow_direction() const
    {
      return (trial_norm / std::max(trial_norm, radius)) * direction;
    }

    /// The derivative of deviatoric_stress() with respect to the strain, where
    /// @p flow, not longer than 1, stands for the flow direction; symmetrised.
    /// With flow_direction() it is the consistent tangent
    /// @cite rudi_shih_stadler_2020.
    DeviatoricTangent<3, Number>
    tangent(const Tensor3 &flow) const
    {
      const Number two_g     = 2. * material.shear_modulus;
      const Number softening = two_g * multiplier / trial_norm; // 1 - theta
      const Number theta_bar = two_g / modulus - softening;
      const Number scale     = std::sqrt(plastic(two_g * theta_bar));
      return {two_g * (1. - softening), scale * direction, scale * flow};
    }

    /// The flow direction that Newton's method predicts for a strain that is
    /// larger by @p increment, if it takes strain and flow direction as
    /// independent unknowns, and @p flow as the present value of the latter:
    /// from the derivative of norm(xi) flow = xi, and shortened to 1.
    Tensor3
    predicted_flow(const Tensor3 &flow, const Tensor3 &increment) const
    {
      const Tensor3 stress_increment = 2. * material.shear_modulus * increment;
      const Tensor3 prediction =
        (trial_norm * direction + stress_increment -
         plastic(direction * stress_increment) * flow) /
        std::max(trial_norm, radius);
      return prediction / std::max(prediction.norm(), Number(1.));
    }

    /// The work of the stress on the plastic strain of the step,
    /// s : (e_p - e_p,n).
    Number
    plastic_work() const
    {
      return multiplier * (deviatoric_stress() * direction);
    }

    /// G |e - e_p|^2 at the end of the step.
    Number
    distortion_energy() const
    {
      const Tensor3 elastic_strain =
        elastic_trial_strain - multiplier * direction;
      return material.shear_modulus * (elastic_strain * elastic_strain);
    }

    /// What hardening has stored at the end of the step,
    /// H alpha^2 / 2 + |beta|^2 / (2 (2/3 H_k)).
    Number
    hardening_energy() const
    {
      return stored_by_hardening(state());
    }

    /// The part of the plastic work that has become heat: what hardening has
    /// not stored. Not negative.
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
      return {old_state.plastic_strain + multiplier * direction,
              old_state.back_stress +
                material.kinematic_modulus * multiplier * direction,
              old_state.equivalent_plastic_strain +
                std::sqrt(2. / 3.) * multiplier};
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
    Number
    stored_by_hardening(const MaterialState<Number> &state) const
    {
      const Number alpha = state.equivalent_plastic_strain;
      // (without kinematic hardening there is no back stress)
      return 0.75 * material.isotropic_modulus * alpha * alpha +
             0.5 * (state.back_stress * state.back_stress) /
               std::max(material.kinematic_modulus, Number(1e-100));
    }

    const Material<Number>       material;
    const MaterialState<Number> &old_state;

    /// 2 G + 2/3 (H + H_k)
    const Number  modulus;
    const Tensor3 elastic_trial_strain;
    Number        trial_norm;
    Tensor3       direction;
    Number        radius;
    /// Delta gamma, the length of the plastic strain increment.
    Number multiplier;
  };
} // namespace ElastoPlastic

#endif
