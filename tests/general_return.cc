// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// A step with the yield criteria of Hosford and Hill at a point: the equations
// that define it, its energy and its tangent, with all laws of hardening that
// do not recover, and with rate dependence.

#include <deal.II/base/mpi.h>

#include <cmath>

#include "sample_criteria.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Tensor3 = SymmetricTensor<2, 3>;



  /// The largest error in the equations of a step that yields, which takes no
  /// time.
  double
  step_error(const Material<double>      &material,
             const Tensor3               &strain,
             const MaterialState<double> &old_state)
  {
    const RadialReturn<double> point(material, strain, old_state);
    const auto                 state = point.state();
    const Tensor3 increment = state.plastic_strain - old_state.plastic_strain;
    const double  growth =
      state.equivalent_plastic_strain - old_state.equivalent_plastic_strain;
    Tensor3 relative = point.deviatoric_stress();
    double  error    = 0;
    for (unsigned int k = 0; k < state.back_stresses.size(); ++k)
      {
        relative -= state.back_stresses[k];
        error = std::max(error,
                         (state.back_stresses[k] - old_state.back_stresses[k] -
                          material.back_stresses[k].modulus * increment)
                           .norm());
      }
    const double stress =
      FlowStress(material, old_state.equivalent_plastic_strain, 0)
        .at(growth)
        .stress;
    const auto &criterion = *material.criteria[0];
    return std::max(
      {error / stress,
       std::abs(equivalent_stress(criterion, relative) - stress) / stress,
       (increment - growth * normal(criterion, relative)).norm() / growth,
       (point.deviatoric_stress() -
        2. * material.shear_modulus * (strain - state.plastic_strain))
           .norm() /
         stress});
  }



  struct DerivativeErrors
  {
    double stress = 0, tangent = 0, symmetry = 0, least_product = 1;
  };



  void
  add_errors(DerivativeErrors            &errors,
             const Material<double>      &material,
             const Tensor3               &strain,
             const MaterialState<double> &old_state)
  {
    const auto at = [&](const Tensor3 &e) {
      return RadialReturn<double>(material, e, old_state);
    };
    const auto   point   = at(strain);
    const auto   tangent = point.general_tangent();
    const double scale   = 2. * material.shear_modulus;
    const double step    = 1e-7;
    for (unsigned int number = 0; number < 4; ++number)
      {
        const Tensor3 direction = deviator(sample_tensor<3>(number, 1.));
        const auto    product   = tangent * direction;
        const auto    ahead     = at(strain + step * direction),
                   behind       = at(strain - step * direction);
        errors.tangent =
          std::max(errors.tangent,
                   ((ahead.deviatoric_stress() - behind.deviatoric_stress()) /
                      (2. * step) -
                    product)
                       .norm() /
                     scale);
        const auto far_ahead  = at(strain + 10. * step * direction),
                   far_behind = at(strain - 10. * step * direction);
        errors.stress =
          std::max(errors.stress,
                   std::abs((far_ahead.energy() - far_behind.energy()) /
                              (20. * step) -
                            point.deviatoric_stress() * direction) /
                     point.deviatoric_stress().norm());
        errors.least_product =
          std::min(errors.least_product, product * direction / scale);
        for (unsigned int other = 0; other < number; ++other)
          {
            const Tensor3 second = deviator(sample_tensor<3>(other, 1.));
            errors.symmetry =
              std::max(errors.symmetry,
                       std::abs(product * second -
                                direction * (tangent * second)) /
                         scale);
          }
      }
  }



  void
  verify_errors(const DerivativeErrors &errors, const bool has_energy)
  {
    verify("  tangent is the derivative of the stress", errors.tangent, 1e-6);
    verify("  symmetric", errors.symmetry, 1e-13);
    verify("  positive semidefinite", -errors.least_product, 1e-13);
    if (has_energy)
      verify("  stress is the derivative of the energy", errors.stress, 1e-6);
  }



  void
  check_steps(const std::string &criterion, const std::string &law)
  {
    output() << criterion << ", " << law << std::endl;
    const auto       material  = material_with(criterion, law);
    double           equations = 0, least_dissipation = 1;
    DerivativeErrors errors;
    for (const auto &old_state :
         {MaterialState<double>(material.back_stresses.size()),
          sample_state(material)})
      for (unsigned int number = 0; number < 20; ++number)
        {
          const Tensor3 strain =
            old_state.plastic_strain +
            deviator(sample_tensor<3>(number, 0.01 * (1 + number)));
          equations =
            std::max(equations, step_error(material, strain, old_state));
          least_dissipation = std::min(
            least_dissipation,
            RadialReturn<double>(material, strain, old_state).dissipation());
          add_errors(errors, material, strain, old_state);
        }
    verify("  yield, flow rule and hardening", equations, 1e-11);
    verify("  dissipation is not negative", -least_dissipation, 1e-12);
    verify_errors(errors, true);
  }



  void
  check_rates(const std::string &criterion, const RateLawType law)
  {
    output() << criterion << ", "
             << Patterns::Tools::Convert<RateLawType>::to_string(law)
             << std::endl;
    const auto       material = material_with(criterion, "Voce", law);
    DerivativeErrors errors;
    for (unsigned int number = 0; number < 20; ++number)
      add_errors(errors,
                 material,
                 deviator(sample_tensor<3>(number, 0.002 * (1 + number))),
                 MaterialState<double>(0));
    verify_errors(errors, has_potential(material));
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string &criterion : all_criteria)
    {
      for (const std::string &law : lasting_laws)
        check_steps(criterion, law);
      for (const RateLawType law : {RateLawType::perzyna,
                                    RateLawType::norton,
                                    RateLawType::cowper_symonds,
                                    RateLawType::duvaut_lions})
        check_rates(criterion, law);
    }
}
