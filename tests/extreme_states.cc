// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What a body makes of states and displacements that no history leads to:
// states from an interpolation that overshoots become admissible, and when the
// return to the yield surface has no solution on one rank, all of them notice.

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/vector_tools.h>

#include "base/compatibility.h"
#include "evaluation/solve_result.h"
#include "material/material_parameters.h"
#include "mechanics/solid_operator.h"
#include "sample_mesh.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// Two that recover, and one that does not.
  MaterialParameters
  chaboche()
  {
    MaterialParameters parameters;
    parameters.laws               = {MaterialLaw::nonlinear_hardening};
    parameters.young_moduli       = {2.};
    parameters.poisson_ratios     = {0.3};
    parameters.yield_stresses     = {0.2};
    parameters.back_stress_moduli = {"4 | 0.3 | 0.1"};
    parameters.recovery_rates     = {"20 | 1 | 0"};
    return parameters;
  }



  class Sheet
  {
  public:
    Sheet()
      : material(chaboche().materials().front())
      , mesh(MPI_COMM_WORLD)
      , fe(FE_Q<2>(1), 2)
      , dof_handler(mesh)
      , solid(1,
              {VolumetricTreatment::standard, Kinematics::plane_stress},
              {material})
    {
      GridGenerator::subdivided_hyper_cube(mesh, 4);
      dof_handler.distribute_dofs(fe);
      constraints = empty_constraints(dof_handler);
      constraints.close();
      solid.reinit(dof_handler, constraints);
      solid.initialize_vector(u);
      VectorTools::interpolate(dof_handler, SampleField<2>(0, 0.5), u);
      solid.commit(u);
    }

    void
    check_states()
    {
      const double     scale  = 300.;
      const CellStates before = solid.states();
      CellStates       states = before;
      for (auto &values : states)
        for (double &value : values)
          value *= -scale;
      solid.set_states(states);
      for_each_point(states,
                     solid.states(),
                     [&](const auto &given, const auto &taken) {
                       verify_point(given, taken);
                     });
      verify("states become admissible", admissible);
      verify("back stresses keep their direction", parallel);
      verify("plastic strains and linear back stresses stay", rest_stays);
      verify("there have been states that were not", found_large);

      solid.set_states(before);
      verify("states of a history stay as they are", solid.states() == before);
    }

    void
    check_rounding_errors()
    {
      VectorType       at_rest(u.get_partitioner());
      const CellStates before = solid.states();
      CellStates       states = before;
      for (auto &values : states)
        for (double &value : values)
          value *= 1e-14;
      verify("a history leaves a plastic volume",
             body_state(solid, at_rest).plastic_volume > 0.);
      solid.set_states(states);
      verify("rounding errors of an interpolation leave none",
             body_state(solid, at_rest).plastic_volume == 0.);
      solid.set_states(before);
    }

    /// The displacement of one node is beyond all bounds.
    void
    check_failing_rank()
    {
      const unsigned int last =
        Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == last)
        u.local_element(u.locally_owned_size() - 1) = 1e300;
      VectorType forces;
      solid.initialize_vector(forces);
      solid.internal_forces(forces, u);
      bool forces_are_finite = true;
      for (const double force : forces)
        forces_are_finite = forces_are_finite && std::isfinite(force);
      verify("forces are no numbers",
             Utilities::MPI::min(int(forces_are_finite), MPI_COMM_WORLD) == 0);
      verify("all ranks see an energy that is none",
             Utilities::MPI::max(int(std::isfinite(solid.energy(u))),
                                 MPI_COMM_WORLD) == 0);
    }

  private:
    using State = MaterialState<double>;

    template <typename Body>
    void
    for_each_point(const CellStates &a, const CellStates &b, const Body &body)
    {
      const unsigned int n_back_stresses = material.back_stresses.size();
      const unsigned int n_values        = State::n_values(n_back_stresses);
      for (unsigned int cell = 0; cell < a.size(); ++cell)
        for (unsigned int i = 0; i < a[cell].size(); i += n_values)
          {
            State state_a(n_back_stresses), state_b(n_back_stresses);
            state_a.unpack(&a[cell][i]);
            state_b.unpack(&b[cell][i]);
            body(state_a, state_b);
          }
    }

    void
    verify_point(const State &given, const State &taken)
    {
      admissible = admissible && taken.equivalent_plastic_strain >= 0;
      rest_stays = rest_stays && taken.plastic_strain == given.plastic_strain &&
                   taken.back_stresses[2] == given.back_stresses[2];
      for (unsigned int k = 0; k < 2; ++k)
        {
          const auto &[c, g] = material.back_stresses[k];
          const auto &beta   = taken.back_stresses[k];
          const auto &large  = given.back_stresses[k];
          admissible = admissible && beta.norm() <= c / g * (1. + 1e-12);
          parallel =
            parallel && std::abs(beta * large - beta.norm() * large.norm()) <=
                          1e-12 * beta.norm() * large.norm();
          found_large = found_large || large.norm() > 2. * c / g;
        }
    }

    const Material<double>                  material;
    parallel::distributed::Triangulation<2> mesh;
    const FESystem<2>                       fe;
    DoFHandler<2>                           dof_handler;
    AffineConstraints<double>               constraints;
    SolidOperator<2>                        solid;
    VectorType                              u;

    bool admissible = true, parallel = true, rest_stays = true,
         found_large = false;
  };
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Sheet                                  sheet;
  sheet.check_states();
  sheet.check_rounding_errors();
  sheet.check_failing_rank();
}
