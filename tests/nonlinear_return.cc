// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// A step with nonlinear hardening: the equations that define backward Euler,
// the energy, what hardening stores and what becomes heat; and many small steps
// against the closed forms of the rate equations.

#include <deal.II/base/mpi.h>

#include <cmath>

#include "material/material_lists.h"
#include "sample_material.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  const double sqrt_two_thirds = std::sqrt(2. / 3.);

  /// The piecewise linear function through (0, 0) and @p points.
  double
  interpolate(const std::vector<HardeningCurve::Point> &points,
              const double                              alpha)
  {
    HardeningCurve::Point last = {0., 0.};
    for (const auto &point : points)
      {
        if (alpha < point.strain)
          return last.rise + (point.rise - last.rise) * (alpha - last.strain) /
                               (point.strain - last.strain);
        last = point;
      }
    return last.rise;
  }



  /// sigma_Y, written down once more.
  double
  yield_stress(const MaterialParameters &p, const double alpha)
  {
    return 400. * std::pow(1. + alpha / p.power_law_reference_strains[0],
                           p.power_law_exponents[0]) +
           p.isotropic_moduli[0] * alpha +
           p.voce_stresses[0] * (1. - std::exp(-p.voce_rates[0] * alpha)) +
           interpolate(read_hardening_table(p.hardening_tables[0], 400.),
                       alpha);
  }



  /// The largest error in the equations of a step that yields.
  double
  step_error(const std::string           &law,
             const SymmetricTensor<2, 3> &strain,
             const MaterialState<double> &old_state)
  {
    const auto                 material = sample_material(law);
    const RadialReturn<double> point(material, strain, old_state);
    const auto                 state  = point.state();
    const auto                 stress = point.deviatoric_stress();

    const auto   increment = state.plastic_strain - old_state.plastic_strain;
    const double gamma     = increment.norm();
    auto         relative  = stress;
    double       evolution = 0;
    for (unsigned int k = 0; k < state.back_stresses.size(); ++k)
      {
        // from beta_0 to the limit c n / g, exponentially
        const auto &[c, g] = material.back_stresses[k];
        const double left  = std::exp(-g * gamma);
        relative -= state.back_stresses[k];
        evolution =
          std::max(evolution,
                   (state.back_stresses[k] - left * old_state.back_stresses[k] -
                    (g > 0. ? (1. - left) / (g * gamma) : 1.) * c * increment)
                     .norm());
      }
    const double radius =
      sqrt_two_thirds *
      yield_stress(sample_parameters(law), state.equivalent_plastic_strain);
    return std::max(
      {std::abs(relative.norm() - radius) / radius,
       evolution / radius,
       (increment - gamma / relative.norm() * relative).norm() / gamma,
       std::abs(state.equivalent_plastic_strain -
                old_state.equivalent_plastic_strain - sqrt_two_thirds * gamma) /
         gamma,
       (stress - 2. * material.shear_modulus * (strain - state.plastic_strain))
           .norm() /
         stress.norm()});
  }



  double
  energy_error(const Material<double>      &material,
               const SymmetricTensor<2, 3> &strain,
               const MaterialState<double> &old_state)
  {
    const auto energy = [&](const SymmetricTensor<2, 3> &e) {
      return RadialReturn<double>(material, e, old_state).energy();
    };
    const auto stress =
      RadialReturn<double>(material, strain, old_state).deviatoric_stress();
    const double step  = 1e-6;
    double       error = 0;
    for (unsigned int number = 0; number < 3; ++number)
      {
        const auto direction = deviator(sample_tensor<3>(number, 1.));
        error                = std::max(error,
                         std::abs((energy(strain + step * direction) -
                                   energy(strain - step * direction)) /
                                    (2 * step) -
                                  stress * direction));
      }
    return error / stress.norm();
  }



  void
  check_steps(const std::string &law)
  {
    const auto material  = sample_material(law);
    double     equations = 0, energy = 0;
    for (const auto &old_state :
         {MaterialState<double>(material.back_stresses.size()),
          sample_state(material)})
      for (unsigned int number = 0; number < 20; ++number)
        {
          const auto strain =
            old_state.plastic_strain +
            deviator(sample_tensor<3>(number, 0.01 * (1 + number)));
          equations = std::max(equations, step_error(law, strain, old_state));
          energy = std::max(energy, energy_error(material, strain, old_state));
        }
    verify("  flow rule, hardening, recovery and consistency",
           equations,
           1e-12);
    if (!has_recovery(material))
      verify("  stress is the derivative of energy", energy, 1e-6);
  }



  /// A walk through strain space: every step becomes the history of the next.
  void
  check_walk(const std::string &law)
  {
    const auto            material = sample_material(law);
    MaterialState<double> state(material.back_stresses.size());
    SymmetricTensor<2, 3> strain;
    double                least_dissipation = 1, balance = 0, bound = 0;
    double                stored = 0, work = 0, dissipation = 0;
    unsigned int          n_plastic = 0;
    for (unsigned int number = 0; number < 300; ++number)
      {
        strain += deviator(sample_tensor<3>(number, 0.006));
        const RadialReturn<double> point(material, strain, state);
        state  = point.state();
        stored = point.hardening_energy();
        work += point.plastic_work();
        dissipation += point.dissipation();
        least_dissipation = std::min(least_dissipation, point.dissipation());
        n_plastic += (point.plastic(1.) > 0);
        for (unsigned int k = 0; k < state.back_stresses.size(); ++k)
          bound = std::max(bound,
                           state.back_stresses[k].norm() *
                             material.back_stresses[k].recovery /
                             material.back_stresses[k].modulus);
      }
    balance = std::abs(work - stored - dissipation) / work;
    verify("  many steps yield", n_plastic >= 20);
    verify("  dissipation is never negative", -least_dissipation, 1e-14 * work);
    verify("  plastic work is stored or dissipated", balance, 1e-12);
    verify("  back stresses stay below their limits", bound <= 1. + 1e-12);
  }



  /// A strain deviator that grows in one direction, as in tension, to the
  /// equivalent strain 0.02 in @p n_steps steps. Returns the equivalent stress
  /// and the equivalent plastic strain.
  std::pair<double, double>
  tension(const std::string &law, const unsigned int n_steps)
  {
    const auto            material = sample_material(law);
    MaterialState<double> state(material.back_stresses.size());
    SymmetricTensor<2, 3> shape;
    shape[0][0] = 1.;
    shape[1][1] = shape[2][2] = -0.5;
    double stress             = 0;
    for (unsigned int i = 1; i <= n_steps; ++i)
      {
        const RadialReturn<double> point(material,
                                         0.02 * i / n_steps * shape,
                                         state);
        stress = std::sqrt(1.5) * point.deviatoric_stress().norm();
        state  = point.state();
      }
    return {stress, state.equivalent_plastic_strain};
  }



  void
  check_tension()
  {
    // one step is exact if nothing recovers
    for (const std::string law : {"Voce", "power law", "table"})
      {
        const auto [stress, alpha] = tension(law, 1);
        verify(law + ": stress is the yield stress",
               std::abs(stress - yield_stress(sample_parameters(law), alpha)),
               1e-9);
      }
    // X = C/gamma (1 - exp(-gamma eps_p)), with any number of steps
    for (const unsigned int n_steps : {1, 7})
      {
        const auto [stress, alpha] = tension("Armstrong-Frederick", n_steps);
        verify("Armstrong-Frederick: closed form",
               std::abs(stress - 400. - 200. * (1. - std::exp(-150. * alpha))),
               1e-9);
      }
  }



  /// The stress after a strain that has gone round a circle in @p n_steps
  /// steps, so that the flow turns all the way.
  SymmetricTensor<2, 3>
  stress_after_circle(const unsigned int n_steps)
  {
    const auto            material = sample_material("Armstrong-Frederick");
    MaterialState<double> state(material.back_stresses.size());
    SymmetricTensor<2, 3> stress;
    for (unsigned int i = 1; i <= n_steps; ++i)
      {
        const double          angle = 2. * numbers::PI * i / n_steps;
        SymmetricTensor<2, 3> strain;
        strain[0][1] = 0.01 * std::sin(angle);
        strain[0][0] = 0.01 * (1. - std::cos(angle)) / std::sqrt(2.);
        strain[1][1] = -strain[0][0];
        const RadialReturn<double> point(material, strain, state);
        stress = point.deviatoric_stress();
        state  = point.state();
      }
    return stress;
  }



  void
  check_turning_flow()
  {
    const auto coarse = stress_after_circle(500),
               medium = stress_after_circle(1000),
               fine   = stress_after_circle(2000);
    const double order =
      std::log2((coarse - medium).norm() / (medium - fine).norm());
    verify("flow that turns: first order in the size of the steps",
           order > 0.95 && order < 1.05);
    verify("1000 steps around a circle are within a per cent",
           2. * (medium - fine).norm() / fine.norm(),
           1e-2);
  }



  /// States as arrays of numbers.
  void
  check_packing()
  {
    const auto          state = sample_state(sample_material("Chaboche"));
    std::vector<double> values(MaterialState<double>::n_values(3));
    state.pack(values.data());
    MaterialState<double> copy(3);
    copy.unpack(values.data());
    verify("a packed state is the same after unpacking",
           copy.plastic_strain == state.plastic_strain &&
             copy.equivalent_plastic_strain ==
               state.equivalent_plastic_strain &&
             copy.back_stresses == state.back_stresses);
    verify("a state has 7 numbers and 6 for each back stress",
           values.size() == 25 &&
             values.back() == state.back_stresses[2].access_raw_entry(5));
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string &law : nonlinear_laws)
    {
      output() << law << std::endl;
      check_steps(law);
      check_walk(law);
    }
  check_tension();
  check_turning_flow();
  check_packing();
}
