// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>

#include "contact_problem.h"
#include "elasto_plastic_contact.h"
#include "mechanics/rigid_body_modes.h"
#include "mesh/body_size.h"

namespace ElastoPlastic
{
  // The heart of the program: the primal-dual active set loop. It lives in
  // SemismoothNewton, which treats contact and plasticity as one nonlinear
  // problem; ContactProblem tells it about energy, forces, tangent and active
  // set. What remains to be done here is a good first guess of the active set
  // (all nodes that the starting displacement brings to the indenter), and to
  // look at what has come out.
  template <int dim>
  SolveResult
  ElastoPlasticContact<dim>::solve()
  {
    Timer       wall_clock(communicator, /* sync_lap_times = */ true);
    SolveResult result;
    result.step  = time_steps.number();
    result.time  = time_steps.next_time();
    result.cycle = cycle;
    result.cells = triangulation.n_global_active_cells();
    result.dofs  = dof_handler.n_dofs();
    log.begin_solve(result);

    {
      TimerOutput::Scope     scope(timer, "Nonlinear solver");
      const SemismoothNewton newton(parameters.newton,
                                    [this](const NewtonStep &step) {
                                      log.newton_step(step);
                                      stop_if_requested();
                                    });

      contact.activate_touching(displacement);
      ContactProblem<dim> problem(*solid,
                                  supports,
                                  external_forces,
                                  contact,
                                  *tangent_solver,
                                  1e4 * body_size(triangulation),
                                  largest_forces,
                                  timer);
      const NewtonReport  report = newton.solve(problem, displacement);
      problem.compute_residual(residual, displacement);
      contact.settle(displacement);

      result.newton_iterations = report.n_iterations();
      result.linear_iterations = report.n_linear_iterations();
      result.residual          = report.steps.back().residual;
      result.energy            = report.steps.back().energy;
      if (result.residual > parameters.newton.tolerance)
        log.warn(
          "The forces on the free unknowns are " +
          Patterns::Tools::to_string(result.residual) +
          " of all forces, above 'Nonlinear solver/Tolerance': parts of the "
          "body are so stiff, or so nearly incompressible, that the rounding "
          "of the displacements does not allow for less.");
    }

    evaluate_contact(result);
    evaluate_plasticity(result);
    estimate_error(result);

    Utilities::System::MemoryStats memory;
    Utilities::System::get_memory_stats(memory);
    result.memory_mb = Utilities::MPI::sum(memory.VmHWM / 1024., communicator);
    wall_clock.stop();
    result.wall_seconds = wall_clock.wall_time();
    log.end_solve(result);
    return result;
  }



  // The contact force is the sum of the residual over the active nodes. It is
  // compared with what the supports feel, which is computed in an independent
  // way (Reactions); the difference is relative to the sum of all nodal forces,
  // because those of the supports may cancel, and to its largest value so far,
  // because after unloading there may be none.
  template <int dim>
  void
  ElastoPlasticContact<dim>::evaluate_contact(SolveResult &result)
  {
    const ContactState state = contact.state(displacement, residual);
    result.active_nodes      = state.n_active;
    result.force             = state.force;
    result.depth           = gap_function.has_indenter() ? contact.depth() : 0.;
    result.contact_area    = state.area;
    result.max_pressure    = state.max_pressure;
    result.min_pressure    = state.min_pressure;
    result.max_penetration = state.max_penetration;
    result.max_hanging_penetration = state.max_hanging_penetration;
    result.complementarity_error   = state.complementarity_error;

    const double reaction =
      reactions.vertical_force(*solid, displacement, loads_on_body());
    double load = 0;
    if (external_forces.l1_norm() > 0)
      load = external_forces * rigid_body_modes(dof_handler, residual)[dim - 1];
    largest_forces =
      std::max(largest_forces, residual.l1_norm() + external_forces.l1_norm());
    if (largest_forces > 0)
      result.force_balance_error =
        std::abs(state.force - reaction - load) / largest_forces;
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::evaluate_plasticity(SolveResult &result) const
  {
    enum
    {
      plastic_volume,
      elastic_energy,
      hardening_energy,
      plastic_work,
      dissipation,
      n_integrals
    };
    std::vector<double> integrals(n_integrals, 0.);
    double              max_strain = 0;
    solid->for_each_cell(displacement, [&](const auto &, const auto &points) {
      for (const PointResult &point : points)
        {
          if (point.plastic)
            integrals[plastic_volume] += point.volume;
          integrals[elastic_energy] += point.elastic_energy * point.volume;
          integrals[hardening_energy] += point.hardening_energy * point.volume;
          integrals[plastic_work] += point.plastic_work * point.volume;
          integrals[dissipation] += point.dissipation * point.volume;
          max_strain = std::max(max_strain, point.equivalent_plastic_strain);
        }
    });
    Utilities::MPI::sum(integrals, communicator, integrals);
    result.plastic_volume   = integrals[plastic_volume];
    result.elastic_energy   = integrals[elastic_energy];
    result.hardening_energy = integrals[hardening_energy];
    result.plastic_work     = integrals[plastic_work];
    result.dissipation      = integrals[dissipation];
    result.max_equivalent_plastic_strain =
      Utilities::MPI::max(max_strain, communicator);
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
