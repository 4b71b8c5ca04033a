// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// A step with each rate law and hardening: the flow stress, the potential, the
// tangent; many steps against the closed forms of the rate equations, and how
// fast they approach these and the material without rate dependence.

#include <deal.II/base/mpi.h>

#include <cmath>
#include <optional>

#include "sample_material.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  const double sqrt_two_thirds = std::sqrt(2. / 3.);

  const RateLaw linear         = {RateLawType::perzyna, 1., 2., 100., 1.};
  const RateLaw perzyna        = {RateLawType::perzyna, 4., 0.01, 150., 1.};
  const RateLaw norton         = {RateLawType::norton, 5., 0.01, 300., 1.};
  const RateLaw cowper_symonds = {RateLawType::cowper_symonds, 5., 40., 1., 1.};
  const RateLaw duvaut_lions   = {RateLawType::duvaut_lions, 1., 1., 1., 0.2};

  Material<double>
  rate_dependent(const std::string &law,
                 const RateLaw     &rate_law,
                 const double       duration)
  {
    auto material          = sample_material(law);
    material.rate_laws[0]  = rate_law;
    material.step_duration = duration;
    material.is_linear     = false;
    return material;
  }



  /// By how much the relative stress at the end of a step differs from that of
  /// flow with the mean rate of the step; or, with relaxation, the stress and
  /// the state from those that it makes of the step without.
  double
  step_error(const Material<double>      &material,
             const SymmetricTensor<2, 3> &strain,
             const MaterialState<double> &old_state)
  {
    const RadialReturn<double> point(material, strain, old_state);
    const auto                 state  = point.state();
    const auto                 stress = point.deviatoric_stress();
    const RateLaw             &rates  = material.rate_laws[0];
    if (rates.type == RateLawType::duvaut_lions)
      {
        auto inviscid         = material;
        inviscid.rate_laws[0] = RateLaw();
        const RadialReturn<double> target(inviscid, strain, old_state);
        const double ratio = material.step_duration / rates.relaxation_time;
        const auto   trial =
          2. * material.shear_modulus * (strain - old_state.plastic_strain);
        double error =
          (stress - (trial + ratio * target.deviatoric_stress()) / (1. + ratio))
            .norm();
        for (unsigned int k = 0; k < state.back_stresses.size(); ++k)
          error = std::max(error,
                           (state.back_stresses[k] -
                            (old_state.back_stresses[k] +
                             ratio * target.state().back_stresses[k]) /
                              (1. + ratio))
                             .norm());
        return error / stress.norm();
      }

    auto relative = stress;
    for (const auto &back_stress : state.back_stresses)
      relative -= back_stress;
    const double alpha = state.equivalent_plastic_strain;
    const double rate =
      (alpha - old_state.equivalent_plastic_strain) / material.step_duration;
    const double yield_stress =
      std::sqrt(1.5) * material.yield_radius +
      1.5 * material.isotropic_modulus * alpha +
      (material.curves[0] ? material.curves[0]->value(alpha) : 0.);
    const double ratio =
      std::pow(rate / rates.reference_rate, 1. / rates.exponent);
    const double flow_stress = rates.type == RateLawType::perzyna ?
                                 yield_stress + rates.stress * ratio :
                               rates.type == RateLawType::norton ?
                                 std::min(rates.stress * ratio, yield_stress) :
                                 yield_stress * (1. + ratio);
    return std::abs(relative.norm() / (sqrt_two_thirds * flow_stress) - 1.);
  }



  /// The largest difference between difference quotients of @p value and
  /// @p derivative, applied to a few directions.
  template <typename Value, typename Derivative>
  double
  derivative_error(const Value                 &value,
                   const Derivative            &derivative,
                   const SymmetricTensor<2, 3> &strain)
  {
    const double step  = 1e-7;
    double       error = 0;
    for (unsigned int number = 0; number < 3; ++number)
      {
        const auto direction  = deviator(sample_tensor<3>(number, 1.));
        const auto difference = (value(strain + step * direction) -
                                 value(strain - step * direction)) /
                                  (2. * step) -
                                derivative(direction);
        error = std::max(error, std::sqrt(double(difference * difference)));
      }
    return error;
  }



  void
  check_steps(const std::string &name, const RateLaw &rate_law)
  {
    double                equations = 0, tangent = 0;
    std::optional<double> energy;
    for (const std::string law : {"perfectly plastic",
                                  "isotropic hardening",
                                  "kinematic hardening",
                                  "Voce",
                                  "everything",
                                  "linear elastic"})
      for (const double duration : {1e-4, 1., 1e4})
        {
          if (law == "linear elastic" && rate_law.type != RateLawType::norton)
            continue;
          const auto material  = rate_dependent(law, rate_law, duration);
          const auto old_state = sample_state(material);
          for (unsigned int number = 0; number < 5; ++number)
            {
              const auto strain =
                old_state.plastic_strain +
                deviator(sample_tensor<3>(number, 0.004 * (1 + number)));
              const auto at = [&](const SymmetricTensor<2, 3> &e) {
                return RadialReturn<double>(material, e, old_state);
              };
              const auto stress = [&](const SymmetricTensor<2, 3> &e) {
                return at(e).deviatoric_stress();
              };
              equations =
                std::max(equations, step_error(material, strain, old_state));
              if (has_potential(material))
                energy =
                  std::max(energy.value_or(0.),
                           derivative_error(
                             [&](const SymmetricTensor<2, 3> &e) {
                               return at(e).energy();
                             },
                             [&](const SymmetricTensor<2, 3> &direction) {
                               return stress(strain) * direction;
                             },
                             strain) /
                             stress(strain).norm());
              const auto product =
                at(strain).tangent().with_flow(at(strain).flow_direction());
              tangent = std::max(tangent,
                                 derivative_error(
                                   stress,
                                   [&](const SymmetricTensor<2, 3> &direction) {
                                     return product.product(direction, 0.);
                                   },
                                   strain) /
                                   (2. * material.shear_modulus));
            }
        }
    verify(name + ": flow stress", equations, 1e-10);
    if (energy)
      verify(name + ": stress is the derivative of energy", *energy, 1e-6);
    verify(name + ": tangent", tangent, 1e-6);
  }



  /// The equivalent stress at t = 1, of a strain deviator in one direction
  /// whose equivalent strain is @p initial at t = 0, at once, and then grows
  /// with a constant @p rate, by @p n_steps steps.
  double
  tension(const std::string &law,
          const RateLaw     &rate_law,
          const double       initial,
          const double       rate,
          const unsigned int n_steps)
  {
    const auto material = rate_dependent(law, rate_law, 1. / n_steps);
    MaterialState<double> state(material.back_stresses.size());
    SymmetricTensor<2, 3> shape;
    shape[0][0] = 1.;
    shape[1][1] = shape[2][2] = -0.5;
    double stress             = 0;
    for (unsigned int i = 1; i <= n_steps; ++i)
      {
        const RadialReturn<double> point(material,
                                         (initial + rate * i / n_steps) * shape,
                                         state);
        stress = std::sqrt(1.5) * point.deviatoric_stress().norm();
        state  = point.state();
      }
    return stress;
  }



  /// Against the @p exact stress: of first order, and what remains if that is
  /// taken away.
  void
  check_tension(const std::string &name,
                const std::string &law,
                const RateLaw     &rate_law,
                const double       initial,
                const double       rate,
                const double       exact)
  {
    const double coarse = tension(law, rate_law, initial, rate, 4000);
    const double fine   = tension(law, rate_law, initial, rate, 8000);
    verify(name, std::abs((2. * fine - coarse) / exact - 1.), 1e-6);
    const double order = std::log2((coarse - exact) / (fine - exact));
    verify(name + ": first order", std::abs(order - 1.), 0.05);
  }



  void
  check_closed_forms()
  {
    const double three_g = 3. * sample_material("Voce").shear_modulus;

    // linear viscosity: q' = 3 G (rate - (q - 400) r / D), q(0) = 400
    RateLaw slow       = linear;
    slow.stress        = three_g * slow.reference_rate; // one unit of time
    const double limit = 0.01 * slow.stress / slow.reference_rate;
    check_tension("constant rate",
                  "perfectly plastic",
                  slow,
                  400. / three_g,
                  0.01,
                  400. + limit * (1. - std::exp(-1.)));

    // relaxation of 800 to 400: q' = -3 G r ((q - 400) / D)^n
    check_tension("relaxation, linear",
                  "perfectly plastic",
                  slow,
                  800. / three_g,
                  0.,
                  400. + 400. * std::exp(-1.));
    RateLaw power        = perzyna;
    power.reference_rate = 150. / three_g;
    check_tension("relaxation, power law",
                  "perfectly plastic",
                  power,
                  800. / three_g,
                  0.,
                  400. +
                    150. * std::pow(std::pow(400. / 150., -3.) + 3., -1. / 3.));
    RateLaw creep        = norton;
    creep.reference_rate = 300. / three_g;
    check_tension("relaxation by creep",
                  "linear elastic",
                  creep,
                  800. / three_g,
                  0.,
                  300. * std::pow(std::pow(800. / 300., -4.) + 4., -1. / 4.));
    RateLaw relaxing         = duvaut_lions;
    relaxing.relaxation_time = 1.;
    check_tension("relaxation, Duvaut-Lions",
                  "perfectly plastic",
                  relaxing,
                  800. / three_g,
                  0.,
                  400. + 400. * std::exp(-1.));
  }



  /// Flow that has become stationary.
  void
  check_stationary()
  {
    const auto stationary = [](const RateLaw &rate_law, const double rate) {
      return tension("perfectly plastic", rate_law, 0., rate, 100);
    };
    const double rate = 0.1;
    verify("stationary: Perzyna",
           std::abs(stationary(perzyna, rate) - 400. -
                    150. * std::pow(rate / 0.01, 1. / 4.)),
           1e-8);
    verify("stationary: Cowper-Symonds",
           std::abs(stationary(cowper_symonds, rate) -
                    400. * (1. + std::pow(rate / 40., 1. / 5.))),
           1e-8);
    verify("stationary: creep",
           std::abs(stationary(norton, 0.02) -
                    300. * std::pow(0.02 / 0.01, 1. / 5.)),
           1e-8);
    verify("stationary: faster than creep, yield",
           std::abs(stationary(norton, rate) - 400.),
           1e-8);
  }



  /// With vanishing viscosity, the material without: linearly in the viscosity.
  void
  check_limit()
  {
    const double without =
      tension("isotropic hardening", RateLaw(), 0., 0.02, 50);
    const auto excess = [&](const double viscosity) {
      RateLaw rate_law = linear;
      rate_law.stress *= viscosity;
      return tension("isotropic hardening", rate_law, 0., 0.02, 50) - without;
    };
    verify("overstress is linear in a small viscosity",
           std::abs(excess(1e-2) / excess(1e-3) / 10. - 1.),
           1e-3);
    const auto duration_zero = rate_dependent("perfectly plastic", perzyna, 0.);
    verify("in no time, nothing flows",
           RadialReturn<double>(duration_zero,
                                deviator(sample_tensor<3>(1, 0.1)),
                                MaterialState<double>(0))
             .state()
             .is_virgin());
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_steps("linear viscosity", linear);
  check_steps("Perzyna", perzyna);
  check_steps("Norton", norton);
  check_steps("Cowper-Symonds", cowper_symonds);
  check_steps("Duvaut-Lions", duvaut_lions);
  check_closed_forms();
  check_stationary();
  check_limit();
}
