// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_run_elasto_plastic_contact_h
#define contact_run_elasto_plastic_contact_h

#include <deal.II/base/timer.h>

#include "base/exceptions.h"
#include "bounds/safe_load.h"
#include "contact_run/discrete_body.h"
#include "contact_run/error_estimate.h"
#include "contact_run/last_step.h"
#include "contact_run/mesh_adaptation.h"
#include "contact_run/solution_output.h"
#include "contact_run/step_evaluation.h"
#include "contact_run/unloading_stiffness.h"
#include "input/parameters.h"
#include "loading/load_program.h"
#include "loading/time_steps.h"
#include "output/log.h"
#include "output/statistics.h"
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
  /// parts. It owns them in the order in which they depend on each other, so
  /// that
  /// reading run() and the functions that it calls, from top to bottom, is
  /// reading the algorithm. The parts are small and know nothing of this class.
  template <int dim>
  class ElastoPlasticContact
  {
  public:
    /// Builds the mesh and checks everything that can be checked before
    /// anything is computed or written. @p parameters say how the problem is
    /// solved, and what is written. Both must outlive this object.
    /// @throws InputError
    ElastoPlasticContact(const Model<dim> &model,
                         const Parameters &parameters,
                         const MPI_Comm    communicator);

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
    // The load history (history.cc), in the order of run().
    void
    run_load_history(const Statistics::Progress &progress);
    void
    take_load_steps(Statistics &statistics);
    void
    finish_step(Statistics &statistics);
    void
    go_on_after_end(Statistics &statistics);

    // A load step (load_step.cc): it ends with commit_step(), or it fails and
    // is taken back.
    Load
    load_at_end_of_step() const;
    void
    predict();
    SolveResult
    solve_on_mesh_sequence(Statistics &statistics);
    SolveResult
    solve();
    void
    find_equilibrium(SolveResult &result);
    VectorType
    displacement_at(const double depth);
    void
    commit_step(SolveResult &result);
    void
    commit_state();
    void
    take_back_step();
    FailedStep<dim>
    step_under_way() const;
    bool
    tractions_grow() const;

    // The mesh of the next step (adaptation.cc).
    void
    adapt_mesh(Statistics &statistics);
    bool
    change_mesh(Statistics &statistics);
    void
    equilibrate_adapted_mesh(Statistics &statistics);
    void
    commit_interpolated_state();

    // Checkpoints (checkpoint.cc).
    void
    save_checkpoint(Statistics &statistics);
    bool
    checkpoint_is_due() const;
    Checkpoint::Contents
    read_checkpoint(Statistics::Progress &progress);
    Statistics::Progress
    load_checkpoint();
    void
    stop_if_requested() const;
    template <typename Archive>
    void
    serialize_progress(Archive &archive, Statistics::Progress &progress);

    // The problem, and how to solve it.
    const Model<dim> &model;
    const Parameters &parameters;
    const MPI_Comm    communicator;

    // The load over time, the step under way, and how many meshes there have
    // been before the present one; the equilibrium that the step begins with.
    LoadProgram  load_program;
    TimeSteps    time_steps;
    unsigned int cycle = 0;
    LastStep     last_step;

    // What tells the user about it.
    Log         log;
    TimerOutput timer;

    // The body on its mesh, and what is said of it and done with it.
    DiscreteBody<dim>   body;
    MeshAdaptation<dim> adaptation;
    StepEvaluation<dim> evaluation;
    ErrorEstimate<dim>  error_estimate;
    SolutionOutput<dim> output;

    UnloadingStiffness<dim> unloading_stiffness;

    // The folder of the results, and the last checkpoint in it; and whether a
    // step is under way that can be taken back when the user wants to stop.
    OutputDirectory  output_directory;
    const Checkpoint checkpoint;
    Timer            time_since_checkpoint;
    bool             step_is_under_way = false;
  };
} // namespace ElastoPlastic

#endif
