// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/exceptions.h"
#include "elasto_plastic_contact.h"
#include "io/checked_write.h"
#include "io/output_directory.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The highest point of the given boundaries: where the indenter touches
    /// first if its tip is there.
    template <int dim>
    double
    highest_point(
      const parallel::distributed::Triangulation<dim> &triangulation,
      const std::set<types::boundary_id>              &boundaries)
    {
      double height = std::numeric_limits<double>::lowest();
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() &&
                boundaries.count(face->boundary_id()) > 0)
              for (const unsigned int v : face->vertex_indices())
                height = std::max(height, face->vertex(v)[dim - 1]);
      return Utilities::MPI::max(height, triangulation.get_communicator());
    }
  } // namespace



  // The members are constructed in the order in which the problem is
  // described: first the body, then what holds it, then what presses on it.
  // Whatever is wrong with the input shows up here, before the first result is
  // written.
  template <int dim>
  ElastoPlasticContact<dim>::ElastoPlasticContact(const Parameters &parameters,
                                                  const MPI_Comm communicator)
    : parameters(parameters)
    , communicator(communicator)
    , screen(communicator, parameters.output.screen)
    , timer(screen.full_stream(), TimerOutput::never, TimerOutput::wall_times)
    , field_output(parameters.output.directory)
    , triangulation(communicator)
    , boundary_names(make_mesh(parameters.geometry, triangulation))
    , boundary_conditions(parameters.boundary_conditions, boundary_names)
    , gap_function(make_gap_function())
    , fe(FE_Q<dim>(parameters.discretization.degree), dim)
    , dof_handler(triangulation)
    , solid(make_solid_operator<dim>(parameters.discretization.degree,
                                     parameters.discretization.treatment(),
                                     parameters.material.materials()))
    , contact([this](const Point<dim> &x) { return gap_function.value(x); })
  {
    setup_body();
    setup_contact();
    check_supports();
    check_reach();
  }



  template <int dim>
  GapFunction<dim>
  ElastoPlasticContact<dim>::make_gap_function() const
  {
    return GapFunction<dim>(parameters.indenter,
                            highest_point(triangulation,
                                          boundary_conditions.ids(
                                            BoundaryConditionType::contact)));
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::run(const bool overwrite)
  {
    screen.print_banner(Utilities::MPI::n_mpi_processes(communicator));
    prepare_output_directory(communicator,
                             parameters.output.directory,
                             overwrite);
    checked_write(communicator,
                  Utilities::MPI::this_mpi_process(communicator) == 0 ?
                    parameters.output.directory + "/parameters.prm" :
                    "",
                  [&](std::ostream &file) {
                    file << parameters.effective_input;
                  });

    Statistics statistics(communicator, parameters.output.directory);
    solve_on_mesh_sequence(statistics);

    timer.print_summary();
    screen.remark("Results are in " + parameters.output.directory);
  }



  // One load step on a sequence of meshes. Each solution, interpolated to the
  // next mesh, is the starting guess there, so that the fine meshes need only
  // a few Newton steps.
  template <int dim>
  void
  ElastoPlasticContact<dim>::solve_on_mesh_sequence(Statistics &statistics)
  {
    const auto &refinement = parameters.refinement;
    SolveResult result;
    for (unsigned int cycle = 0; cycle < refinement.n_cycles; ++cycle)
      {
        if (cycle > 0)
          refine_mesh();
        if (refinement.max_unknowns > 0 &&
            dof_handler.n_dofs() > refinement.max_unknowns)
          {
            if (cycle == 0)
              throw InputError("Refinement/Maximum number of unknowns",
                               std::to_string(refinement.max_unknowns),
                               "the first mesh has " +
                                 std::to_string(dof_handler.n_dofs()) +
                                 " unknowns already. Allow more, or start with "
                                 "a coarser mesh.");
            screen.remark(
              "The next mesh would have more unknowns than "
              "'Refinement/Maximum number of unknowns' allows.");
            break;
          }

        result = solve(cycle);
        statistics.add_solve(result);
        output_results(cycle);
      }
    statistics.add_step(result, parameters.loading.final_time);
  }



  // Whether a cycle is the last one is known in advance only if the number of
  // unknowns is not limited. If it is, each cycle's fields replace those of the
  // one before.
  template <int dim>
  void
  ElastoPlasticContact<dim>::output_results(const unsigned int cycle)
  {
    const bool every_cycle = (parameters.output.fields == "every cycle");
    const bool may_be_last = (cycle + 1 == parameters.refinement.n_cycles ||
                              parameters.refinement.max_unknowns > 0);
    if (parameters.output.fields == "never" || !(every_cycle || may_be_last))
      return;

    TimerOutput::Scope scope(timer, "Output");
    field_output.write({dof_handler,
                        supports.constraints(),
                        *solid,
                        contact,
                        boundary_conditions.ids(BoundaryConditionType::contact),
                        displacement,
                        residual,
                        error_indicators},
                       every_cycle ? Utilities::int_to_string(cycle, 3) :
                                     "last",
                       cycle);
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
