// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_run_elasto_plastic_contact_h
#define contact_run_elasto_plastic_contact_h

#include <deal.II/base/timer.h>

#include "base/exceptions.h"
#include "contact_run/discrete_body.h"
#include "contact_run/error_estimate.h"
#include "contact_run/load_step.h"
#include "contact_run/mesh_adaptation.h"
#include "contact_run/solution_output.h"
#include "contact_run/step_evaluation.h"
#include "contact_run/unloading_stiffness.h"
#include "input/parameters.h"
#include "output/log.h"
#include "output/run_tables.h"
#include "problem/model.h"
#include "restart/checkpoint.h"
#include "restart/output_directory.h"

namespace ElastoPlastic
{
  /// The contact problem of an elasto-plastic body and a rigid indenter
  /// (doc/theory): find the displacement u that minimises the energy
  ///
  ///   Pi(u) = int_Omega W(strain(u)) dx - int_Gamma_t traction . u ds
  ///
  /// among all u that satisfy the support conditions and, on Gamma_0, do not
  /// penetrate the indenter: u_d <= g - delta,
  /// in one load step, or in many steps of a load history, each of which begins
  /// with what the material remembers of those before. With friction, forces
  /// without an energy join in (ContactProblem).
  ///
  /// This is the one class that sets up, solves, refines and writes, by its
  /// parts. It owns them in the order in which they depend on each other, and
  /// elasto_plastic_contact.cc, read from top to bottom, is the algorithm. The
  /// parts are small and know nothing of this class.
  template <int dim>
  class ElastoPlasticContact
  {
  public:
    /// Builds the mesh and checks everything that can be checked before
    /// anything is computed or written. @p parameters say how the problem is
    /// solved, and what is written. Both must outlive this object.
    /// @p make_error_bound is called if they ask for a guaranteed bound.
    /// @throws InputError
    ElastoPlasticContact(const Model<dim>               &model,
                         const Parameters               &parameters,
                         const MPI_Comm                  communicator,
                         const MakeGuaranteedError<dim> &make_error_bound);

    /// Checks that the indenter can touch the body, which depends on how fine
    /// the mesh is. @throws InputError
    void
    check_contact() const;

    /// Checks that resume() has something to go on from. Afterwards, this
    /// object is of no more use. @throws InputError
    void
    check_checkpoint();

    /// Follows the load history, refines the mesh, and writes the results to
    /// the output directory. @p overwrite allows to replace earlier ones.
    /// @throws InputError, ConvergenceError, EquilibriumError, FileError
    void
    run(const bool overwrite);

    /// Goes on from the last checkpoint in the output directory, as if the run
    /// had not been interrupted.
    /// @throws the same
    void
    resume();

  private:
    // The load history, in the order of run().
    void
    run_load_history(const RunTables::Progress &progress);
    void
    take_load_steps(RunTables &statistics);
    bool
    take_step(RunTables &statistics);
    SolveResult
    solve_on_mesh_sequence(RunTables &statistics);
    SolveResult
    solve();
    void
    require_reachable_surface() const;
    void
    go_on_to_next_step(RunTables &statistics);
    bool
    change_mesh(RunTables &statistics);

    // Checkpoints (checkpoint.cc).
    void
    save_checkpoint(RunTables &statistics);
    bool
    checkpoint_is_due() const;
    [[noreturn]] void
    keep_what_has_been_computed(const Error &error, RunTables &statistics);
    Checkpoint::Contents
    read_checkpoint(RunTables::Progress &progress);
    RunTables::Progress
    load_checkpoint();
    void
    stop_if_requested() const;
    void
    go_on_after_end(RunTables &statistics);
    template <typename Archive>
    void
    serialize_progress(Archive &archive, RunTables::Progress &progress);

    // The problem, and how to solve it.
    const Model<dim>      &model;
    const Parameters      &parameters;
    const MPI_Comm         communicator;
    const SemismoothNewton newton;

    // What tells the user about it.
    Log         log;
    TimerOutput timer;

    // The body on its mesh, the step under way, and what is said of them.
    DiscreteBody<dim>   body;
    LoadStep<dim>       step;
    MeshAdaptation<dim> adaptation;
    StepEvaluation<dim> evaluation;
    ErrorEstimate<dim>  error_estimate;
    SolutionOutput<dim> output;

    UnloadingStiffness<dim> unloading_stiffness;

    // The folder of the results, and the last checkpoint in it.
    OutputDirectory  output_directory;
    const Checkpoint checkpoint;
    Timer            time_since_checkpoint;
  };
} // namespace ElastoPlastic

#endif
