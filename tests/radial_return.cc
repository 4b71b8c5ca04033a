// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The law at a point: load histories with a closed form (uniaxial strain and
// uniaxial stress with reversal), and the properties that define it. Nonlinear
// laws: nonlinear_return.cc.

#include <deal.II/base/mpi.h>

#include <iomanip>

#include "base/simd.h"
#include "sample_material.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// Plasticity in one dimension, integrated in closed form: stress =
  /// stiffness (strain - plastic strain), linear hardening. Radial histories
  /// of the law in three dimensions reduce to it.
  class ScalarPlasticity
  {
  public:
    ScalarPlasticity(const std::string &law, const double stiffness)
      : stiffness(stiffness)
    {
      const MaterialParameters p = sample_parameters(law);
      if (law != "linear elastic")
        yield_stress = p.yield_stresses[0];
      if (law == "isotropic hardening" || law == "combined hardening")
        isotropic_modulus = p.isotropic_moduli[0];
      if (law == "kinematic hardening" || law == "combined hardening")
        kinematic_modulus = p.kinematic_moduli[0];
    }

    double
    stress_at(const double strain)
    {
      const double relative = stiffness * (strain - plastic_strain) -
                              kinematic_modulus * plastic_strain;
      const double excess =
        std::abs(relative) - yield_stress - isotropic_modulus * accumulated;
      if (excess > 0)
        {
          const double length =
            excess / (stiffness + isotropic_modulus + kinematic_modulus);
          plastic_strain += std::copysign(length, relative);
          accumulated += length;
        }
      return stiffness * (strain - plastic_strain);
    }

  private:
    const double stiffness;
    double       yield_stress      = std::numeric_limits<double>::infinity();
    double       isotropic_modulus = 0;
    double       kinematic_modulus = 0;
    double       plastic_strain    = 0;
    double       accumulated       = 0;
  };



  /// A point under the strain diag(axial, lateral, lateral).
  class Specimen
  {
  public:
    struct Stress
    {
      double axial, lateral;
    };

    explicit Specimen(const Material<double> &material)
      : material(material)
      , state(material.back_stresses.size())
    {}

    Stress
    stress(const double axial, const double lateral) const
    {
      const double pressure = material.bulk_modulus * (axial + 2. * lateral);
      const auto   s        = point_law(axial, lateral).deviatoric_stress();
      return {pressure + s[0][0], pressure + s[1][1]};
    }

    void
    commit(const double axial, const double lateral)
    {
      state = point_law(axial, lateral).state();
    }

    /// The lateral strain that leaves no lateral stress, by bisection.
    double
    free_lateral_strain(const double axial) const
    {
      double lower = -1, upper = 1;
      for (unsigned int i = 0; i < 70; ++i)
        {
          const double middle = 0.5 * (lower + upper);
          (stress(axial, middle).lateral < 0 ? lower : upper) = middle;
        }
      return 0.5 * (lower + upper);
    }

  private:
    RadialReturn<double>
    point_law(const double axial, const double lateral) const
    {
      SymmetricTensor<2, 3> strain;
      strain[0][0] = axial;
      strain[1][1] = strain[2][2] = lateral;
      return RadialReturn<double>(material, deviator(strain), state);
    }

    const Material<double> material;
    MaterialState<double>  state;
  };



  void
  uniaxial_strain(const std::string &law)
  {
    const Material<double> material = sample_material(law);
    Specimen               specimen(material);
    ScalarPlasticity       exact(law, 3. * material.shear_modulus);

    output() << "  uniaxial strain:";
    double error = 0;
    for (const double strain : {0.005, 0.01, 0.})
      {
        const auto   stress     = specimen.stress(strain, 0.);
        const double equivalent = exact.stress_at(2. / 3. * strain);
        const double pressure   = material.bulk_modulus * strain;
        specimen.commit(strain, 0.);
        error = std::max(
          {error,
           std::abs(stress.axial - pressure - 2. / 3. * equivalent),
           std::abs(stress.lateral - pressure + 1. / 3. * equivalent)});
        output() << ' ' << stress.axial << " / " << stress.lateral;
      }
    output() << std::endl;
    verify("  closed form", error, 1e-8);
  }



  void
  uniaxial_stress(const std::string &law)
  {
    Specimen         specimen(sample_material(law));
    ScalarPlasticity exact(law, 200000.);

    output() << "  uniaxial stress:";
    double error = 0;
    for (const double strain : {0.02, -0.02, 0.})
      {
        const double lateral = specimen.free_lateral_strain(strain);
        const double stress  = specimen.stress(strain, lateral).axial;
        specimen.commit(strain, lateral);
        error = std::max(error, std::abs(stress - exact.stress_at(strain)));
        output() << ' ' << stress;
      }
    output() << std::endl;
    verify("  closed form", error, 1e-8);
  }



  /// The derivative of the energy is the stress.
  double
  energy_error(const Material<double>      &material,
               const SymmetricTensor<2, 3> &strain,
               const MaterialState<double> &old_state)
  {
    const auto stress =
      RadialReturn<double>(material, strain, old_state).deviatoric_stress();
    const double step  = 1e-6;
    double       error = 0;
    for (unsigned int number = 0; number < 3; ++number)
      {
        const auto   direction = deviator(sample_tensor<3>(number, 1.));
        const double forward =
          RadialReturn<double>(material, strain + step * direction, old_state)
            .energy();
        const double backward =
          RadialReturn<double>(material, strain - step * direction, old_state)
            .energy();
        error = std::max(error,
                         std::abs((forward - backward) / (2 * step) -
                                  stress * direction));
      }
    return error / stress.norm();
  }



  /// Prager's rule.
  double
  back_stress_error(const Material<double>      &material,
                    const SymmetricTensor<2, 3> &plastic_strain_increment,
                    const MaterialState<double> &old_state,
                    const MaterialState<double> &state)
  {
    double error = 0;
    for (unsigned int k = 0; k < state.back_stresses.size(); ++k)
      error =
        std::max(error,
                 (state.back_stresses[k] - old_state.back_stresses[k] -
                  material.back_stresses[k].modulus * plastic_strain_increment)
                   .norm());
    return error;
  }



  /// Whether a step that yields ends on the yield surface, and a state obeys
  /// its definition: deviatoric, flow along s - beta, Prager's rule, alpha.
  double
  flow_error(const Material<double>      &material,
             const SymmetricTensor<2, 3> &strain,
             const MaterialState<double> &old_state)
  {
    const RadialReturn<double> point(material, strain, old_state);
    const auto                 state    = point.state();
    const auto                 stress   = point.deviatoric_stress();
    auto                       relative = stress;
    for (const auto &back_stress : state.back_stresses)
      relative -= back_stress;
    const auto   increment = state.plastic_strain - old_state.plastic_strain;
    const double radius =
      material.yield_radius + material.isotropic_modulus * std::sqrt(1.5) *
                                state.equivalent_plastic_strain;
    return std::max(
      {std::abs(relative.norm() - radius) / radius,
       std::abs(trace(state.plastic_strain)) / strain.norm(),
       (stress - 2. * material.shear_modulus * (strain - state.plastic_strain))
           .norm() /
         stress.norm(),
       (increment - increment.norm() / relative.norm() * relative).norm() /
         increment.norm(),
       back_stress_error(material, increment, old_state, state) / radius,
       std::abs(state.equivalent_plastic_strain -
                old_state.equivalent_plastic_strain -
                std::sqrt(2. / 3.) * increment.norm()) /
         increment.norm()});
  }



  void
  defining_properties(const std::string &law)
  {
    const Material<double> material = sample_material(law);
    const auto             small    = deviator(sample_tensor<3>(5, 1e-4));
    const auto             large    = deviator(sample_tensor<3>(5, 0.02));
    const bool             yields   = (law != "linear elastic");

    const MaterialState<double> virgin(material.back_stresses.size());
    const MaterialState<double> loaded = sample_state(material);
    for (const auto &old_state : {virgin, loaded})
      {
        const bool is_virgin = (old_state.plastic_strain.norm() == 0.);
        output() << "  from a " << (is_virgin ? "virgin" : "loaded") << " state"
                 << std::endl;
        const auto                 unchanged = old_state.plastic_strain + small;
        const RadialReturn<double> elastic(material, unchanged, old_state);
        verify("    an elastic step changes nothing",
               elastic.plastic(1.) == 0. &&
                 elastic.state().plastic_strain == old_state.plastic_strain &&
                 elastic.state().back_stresses == old_state.back_stresses &&
                 elastic.state().equivalent_plastic_strain ==
                   old_state.equivalent_plastic_strain);
        verify("    stress is the derivative of energy, elastic",
               energy_error(material, unchanged, old_state),
               1e-6);
        verify("    stress is the derivative of energy, large strain",
               energy_error(material, large, old_state),
               1e-6);
        if (yields)
          verify("    flow rule, hardening and consistency",
                 flow_error(material, large, old_state),
                 1e-12);
      }
  }



  /// One step from the virgin state is Hencky's law, which does not tell the
  /// kinds of hardening apart.
  void
  virgin_step()
  {
    const auto strain = deviator(sample_tensor<3>(5, 0.02));
    const auto stress = [&](const std::string &law) {
      const auto                  material = sample_material(law);
      const MaterialState<double> virgin(material.back_stresses.size());
      return RadialReturn<double>(material, strain, virgin).deviatoric_stress();
    };
    const auto isotropic = stress("isotropic hardening");
    verify("isotropic = kinematic hardening in one virgin step",
           (stress("kinematic hardening") - isotropic).norm(),
           1e-10);
    verify("isotropic = combined hardening in one virgin step",
           (stress("combined hardening") - isotropic).norm(),
           1e-10);
  }



  /// Each lane of a batch has its own material and strain; a lane without any
  /// strain and an elastic one must not disturb the others.
  void
  lanes(const std::vector<std::string> &laws)
  {
    using Batch          = Simd<double>;
    const auto strain_of = [](const unsigned int lane) {
      return deviator(sample_tensor<3>(lane, 0.005 * lane));
    };

    std::vector<Material<double>>                       materials;
    std::array<const Material<double> *, Batch::size()> of_lane;
    for (const std::string &law : laws)
      materials.push_back(sample_material(law));
    for (unsigned int lane = 0; lane < Batch::size(); ++lane)
      of_lane[lane] = &materials[lane % materials.size()];
    const auto material = join_lanes<Batch>(of_lane, max_back_stresses);
    const MaterialState<Batch>   virgin(max_back_stresses);
    SymmetricTensor<2, 3, Batch> strain;
    for (unsigned int lane = 0; lane < Batch::size(); ++lane)
      for (unsigned int i = 0; i < 6; ++i)
        strain.access_raw_entry(i)[lane] = strain_of(lane).access_raw_entry(i);

    const RadialReturn<Batch> batch(material, strain, virgin);
    const auto                stress    = batch.deviatoric_stress();
    const auto                direction = batch.flow_direction();
    double                    error     = 0;
    for (unsigned int lane = 0; lane < Batch::size(); ++lane)
      {
        const MaterialState<double> old_state(
          of_lane[lane]->back_stresses.size());
        const RadialReturn<double> point(*of_lane[lane],
                                         strain_of(lane),
                                         old_state);
        const auto                 expected = point.deviatoric_stress();
        const auto                 expected_direction = point.flow_direction();
        for (unsigned int i = 0; i < 6; ++i)
          error = std::max({error,
                            std::abs(stress.access_raw_entry(i)[lane] -
                                     expected.access_raw_entry(i)),
                            std::abs(direction.access_raw_entry(i)[lane] -
                                     expected_direction.access_raw_entry(i))});
      }
    verify("lanes of a batch do not disturb each other", error, 1e-9);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  output() << std::fixed << std::setprecision(7);
  for (const std::string &law : all_laws)
    {
      output() << law << std::endl;
      uniaxial_strain(law);
      uniaxial_stress(law);
      defining_properties(law);
    }
  virgin_step();
  lanes(all_laws);
  lanes({"Chaboche", "linear elastic", "everything", "isotropic hardening"});
}
