// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef elasto_plastic_contact_h
#define elasto_plastic_contact_h

#include <deal.II/base/timer.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>

#include <memory>
#include <optional>

#include "base/exceptions.h"
#include "contact/contact_set.h"
#include "contact/gap_function.h"
#include "error_bound_analysis.h"
#include "evaluation/indentation_test.h"
#include "io/checkpoint.h"
#include "io/field_output.h"
#include "io/log.h"
#include "io/output_directory.h"
#include "io/parameters.h"
#include "io/statistics.h"
#include "loading/load_program.h"
#include "loading/time_steps.h"
#include "mechanics/reactions.h"
#include "mechanics/solid_operator.h"
#include "mechanics/supports.h"
#include "model/model.h"
#include "solver/semismooth_newton.h"
#include "solver/tangent_solver.h"

namespace ElastoPlastic
{
  /// The contact problem of an elasto-plastic body and a rigid indenter
  /// (doc/theory.md): find the displacement u that minimises the energy
  ///
  ///   Pi(u) = int_Omega W(strain(u)) dx - int_Gamma_t traction . u ds
  ///
  /// among all u that satisfy the support conditions and, on Gamma_0, do not
  /// penetrate the indenter: u_d <= g - delta,
  /// in one load step, or in many steps of a load history, each of which begins
  /// with what the material remembers of those before.
  ///
  /// This is the one class that sets up, solves, refines and writes. It owns
  /// its parts in the order in which they depend on each other, so that
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
    // The outline, in the order of run() (core.cc):
    void
    run_load_history(const Statistics::Progress &progress);
    void
    take_load_steps(Statistics &statistics);
    SolveResult
    solve_on_mesh_sequence(Statistics &statistics);
    [[noreturn]] void
    give_up(const ConvergenceError &error) const;
    bool
    tractions_grow() const;

    // A load step (load_step.cc): it ends with commit_step(), or it fails and
    // is taken back.
    void
    apply_load();
    void
    predict();
    void
    take_back_step();
    void
    commit_step(SolveResult &result);
    void
    commit_state();
    VectorType
    forces_of_stresses() const;

    // One mesh (setup.cc): after any change of the mesh, setup_body() and
    // setup_contact() prepare everything that depends on it; check_loads()
    // looks at all steps ahead, and check_supports() makes sure that the body
    // cannot float away.
    void
    setup_body();
    void
    setup_contact();
    void
    check_loads() const;
    void
    check_supports() const;
    bool
    is_pressed_against_indenter(const VectorType &motion) const;
    void
    check_reach() const;
    double
    estimated_unknowns(const double n_cells) const;

    // One solve (solve.cc): contact and plasticity in one Newton loop, and
    // what its solution says.
    SolveResult
    solve();
    void
    evaluate_contact(SolveResult &result);
    void
    evaluate_plasticity(SolveResult &result) const;

    // The next mesh (refinement.cc), if there is to be one, in the first load
    // step or after any other.
    void
    estimate_error(SolveResult &result);
    void
    bound_error(SolveResult &result);
    bool
    mark_next_mesh();
    void
    refine_mesh();
    void
    adapt_mesh(Statistics &statistics);
    void
    equilibrate_adapted_mesh(Statistics &statistics);
    void
    commit_interpolated_state();
    bool
    mark_adapted_mesh();

    // What a test in a laboratory would measure (evaluation.cc).
    std::vector<double>
    support_forces() const;
    VectorType
    loads_on_body() const;
    std::optional<IndentationTest>
    make_indentation_test() const;

    // Results (core.cc) and checkpoints (checkpoint.cc).
    void
    output_results(const bool last_cycle);
    void
    save_checkpoint(Statistics &statistics);
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
    // been before the present one.
    LoadProgram  load_program;
    TimeSteps    time_steps;
    unsigned int cycle = 0;

    // What tells the user about it.
    mutable Log         log;
    mutable TimerOutput timer;
    FieldOutput<dim>    field_output;

    // The body, and the indenter above it.
    parallel::distributed::Triangulation<dim> triangulation;
    const GapFunction<dim>                    gap_function;

    // The finite element space; which of its unknowns are constrained or
    // fixed; the body's response; the nodes that may touch the indenter.
    const FESystem<dim>                 fe;
    DoFHandler<dim>                     dof_handler;
    Supports<dim>                       supports;
    std::unique_ptr<SolidOperator<dim>> solid;
    const Reactions<dim>                reactions;
    ContactSet<dim>                     contact;

    // Linear algebra. The residual is the force that the supports and the
    // indenter take from the body; it vanishes at all other unknowns.
    std::unique_ptr<TangentSolver>    tangent_solver;
    VectorType                        external_forces;
    VectorType                        displacement;
    VectorType                        residual;
    Vector<float>                     error_indicators;
    std::optional<ErrorBoundAnalysis> error_bound;
    /// Why the last mesh has none; empty if it has.
    std::string missing_bound;

    // The end of the last load step: what it has found, the displacement, and
    // the nodal forces of the stresses (both empty before the second step); and
    // how fast displacement and depth have changed in it.
    SolveResult last_step;
    VectorType  committed_displacement;
    VectorType  committed_forces;
    VectorType  displacement_rate;
    double      depth_rate = 0;

    // The largest sum of the magnitudes of all nodal forces so far: what small
    // ones are measured against.
    double largest_forces = 0;

    // The folder of the results, and the last checkpoint in it; and whether a
    // step is under way that can be taken back when the user wants to stop.
    OutputDirectory  output_directory;
    const Checkpoint checkpoint;
    bool             step_is_under_way = false;
  };
} // namespace ElastoPlastic

#endif
