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
#include "contact/contact_zone.h"
#include "contact/gap_function.h"
#include "contact_problem.h"
#include "error_bound_analysis.h"
#include "evaluation/boundary_displacements.h"
#include "evaluation/imprint.h"
#include "evaluation/last_step.h"
#include "evaluation/probe_points.h"
#include "evaluation/small_strain_guard.h"
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
  /// with what the material remembers of those before. With friction, forces
  /// without an energy join in (ContactProblem).
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

    /// Checks that the indenter can touch the body, which depends on how fine
    /// the mesh is. @throws InputError
    void
    check_contact() const;

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
    void
    warn_of_large_strains(const SolveResult &result);
    void
    finish_step(Statistics &statistics);
    void
    go_on_after_end(Statistics &statistics);
    SolveResult
    solve_on_mesh_sequence(Statistics &statistics);
    void
    output_results(const bool last_cycle);
    void
    output_initial_state();
    void
    write_fields(const std::string &name, const double time);
    StepResult
    evaluate_step(const SolveResult &result) const;
    bool
    writes_surface_profile(const double time) const;
    bool
    fields_are_due() const;
    void
    remark_on_holds();

    // A load step (load_step.cc): it ends with commit_step(), or it fails and
    // is taken back.
    void
    apply_load();
    Tensor<1, dim - 1>
    sideways_position(const double time) const;
    void
    move_indenter(const double time);
    void
    predict();
    void
    take_back_step();
    void
    commit_step(SolveResult &result);
    void
    commit_state();
    void
    look_at_contact();
    ContactZone<dim>
    contact_zone() const;
    VectorType
    total_slip() const;
    VectorType
    forces_of_stresses() const;
    bool
    tractions_grow() const;

    // One mesh (solve.cc): after any change of the mesh, setup_body() and
    // setup_contact() prepare everything that depends on it.
    void
    setup_body();
    void
    setup_contact();
    VectorType
    external_forces_at(const double time) const;

    // One solve: contact and plasticity in one Newton loop, and
    // what its solution says.
    SolveResult
    solve();
    void
    find_equilibrium(SolveResult &result);
    ContactProblem<dim>
    problem_with(ContactSet<dim> &contact);
    VectorType
    displacement_at(const double depth);
    void
    check_force_balance(SolveResult &result);
    void
    estimate_error(SolveResult &result);
    void
    find_error_indicators();
    void
    bound_error(SolveResult &result);
    void
    measure_imprint(SolveResult &result);
    void
    measure_elements(SolveResult &result);
    ContactSurface<dim>
    contact_surface() const;

    // The next mesh (refinement.cc), if there is to be one, in the first load
    // step or after any other.
    bool
    mark_next_mesh();
    bool
    mark_adapted_mesh();
    bool
    mark_contact_zone();
    bool
    next_mesh_is_allowed() const;
    bool
    adaptation_is_due() const;
    void
    refine_mesh();
    void
    adapt_mesh(Statistics &statistics);
    void
    equilibrate_adapted_mesh(Statistics &statistics);
    void
    commit_interpolated_state();

    // Checkpoints (checkpoint.cc).
    void
    save_checkpoint(Statistics &statistics);
    bool
    checkpoint_is_due() const;
    Statistics::Progress
    load_checkpoint();
    void
    stop_if_requested() const;
    template <typename Archive>
    void
    serialize_progress(Archive &archive, Statistics::Progress &progress);
    std::vector<VectorType *>
    fields_of_last_step(VectorType &response);

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
    GapFunction<dim>                          gap_function;
    const int                                 finest_first_level;

    // Whether they stay within the theory.
    SmallStrainGuard<dim> small_strain_guard;

    // The finite element space; which of its unknowns are constrained or
    // fixed; the body's response; the nodes that may touch the indenter.
    const FESystem<dim>                 fe;
    DoFHandler<dim>                     dof_handler;
    Supports<dim>                       supports;
    std::unique_ptr<SolidOperator<dim>> solid;
    const Reactions<dim>                reactions;
    ContactSet<dim>                     contact;

    // What the tables say beside loads and reactions.
    const BoundaryDisplacements<dim> boundary_displacements;
    const ProbePoints<dim>           probe_points;
    Imprint<dim>                     imprint;

    // Linear algebra. The residual is the force that the supports and the
    // indenter take from the body; it vanishes at all other unknowns.
    std::unique_ptr<TangentSolver>         tangent_solver;
    VectorType                             external_forces;
    VectorType                             displacement;
    VectorType                             residual;
    Vector<float>                          error_indicators;
    std::optional<ErrorBoundAnalysis<dim>> error_bound;

    // What the step under way begins with; the largest sum of the magnitudes
    // of all nodal forces so far, which small ones are measured against; and
    // the largest contact area.
    LastStep last_step;
    double   largest_forces       = 0;
    double   largest_contact_area = 0;

    // The folder of the results, and the last checkpoint in it; and whether a
    // step is under way that can be taken back when the user wants to stop.
    OutputDirectory  output_directory;
    const Checkpoint checkpoint;
    Timer            time_since_checkpoint;
    bool             step_is_under_way = false;
  };
} // namespace ElastoPlastic

#endif
