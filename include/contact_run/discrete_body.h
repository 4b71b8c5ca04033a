// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_run_discrete_body_h
#define contact_run_discrete_body_h

#include <deal.II/base/timer.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>

#include <memory>
#include <set>
#include <vector>

#include "adaptivity/contact_zone.h"
#include "contact/contact_evaluation.h"
#include "contact/contact_set.h"
#include "contact/gap_function.h"
#include "contact_run/last_step.h"
#include "evaluation/contact_surface.h"
#include "loads/supports.h"
#include "mechanics/solid_operator.h"
#include "output/log.h"
#include "problem/model.h"
#include "solver/semismooth_newton.h"
#include "solver/solver_parameters.h"
#include "solver/tangent_solver.h"

namespace ElastoPlastic
{
  /// The body of a Model on its present mesh: what holds it, what it does, the
  /// nodes that may touch the indenter, and where it is. Whatever depends on
  /// the mesh is here, in the order in which it is made; reinit() makes all of
  /// it, and nothing else does. LoadStep tells it what happens in a step.
  ///
  /// All functions are collective, and all vectors have the layout of the
  /// present mesh.
  template <int dim>
  class DiscreteBody
  {
  public:
    using Mesh = parallel::distributed::Triangulation<dim>;

    /// Makes the first mesh, without unknowns. All arguments must outlive this
    /// object. @throws InputError
    DiscreteBody(const Model<dim>             &model,
                 const LinearSolverParameters &linear_solver,
                 const MPI_Comm                communicator,
                 Log                          &log,
                 TimerOutput                  &timer);

    /// Prepares everything that depends on the mesh, for the end of a load step
    /// at @p time, with this @p load of the indenter. The displacement is zero,
    /// the material is virgin and bears the initial stress.
    /// @throws InputError if that is far from an equilibrium.
    void
    reinit(const double time, const Load &load);

    /// Lets the material remember what go_on() needs. To be called before
    /// reinit().
    void
    keep_increments()
    {
      solid_body.keep_increments();
    }

    /// Obeys the flags of the triangulation, and takes the displacement and the
    /// states of the material to the new mesh, with what of @p last the next
    /// step is guessed from. Otherwise like reinit().
    void
    refine(const double time, const Load &load, LastStep &last);

    /// A load step begins, which leads from time @p begin to @p end and there
    /// to this @p load of the indenter.
    void
    begin_step(const double begin, const double end, const Load &load);

    /// The load step that has begun goes on after @p last for this @p duration,
    /// in the same direction: the material is integrated by two-step backward
    /// differentiation. After keep_increments() only.
    void
    go_on(const LastStep &last, const double duration)
    {
      solid_body.go_on(duration, last.duration);
    }

    /// Goes on from @p last for this @p duration at the rates of that step,
    /// which are stretched with a contact that grows: the guess that
    /// find_equilibrium() begins with.
    void
    extrapolate(const LastStep &last, const double duration);

    /// Finds the equilibrium at the end of the step which follows @p last, and
    /// adds up in @p result, which knows the time, how it has been found.
    /// @throws ConvergenceError
    void
    find_equilibrium(const SemismoothNewton &newton,
                     const LastStep         &last,
                     SolveResult            &result);

    /// The displacement in equilibrium if the indenter were at @p depth; all
    /// stays as it is. @throws ConvergenceError
    VectorType
    displacement_at(const double            depth,
                    const SemismoothNewton &newton,
                    const LastStep         &last);

    /// The material, and @p last, take this equilibrium as the one that the
    /// next step begins with.
    void
    commit(LastStep &last);

    /// Goes back to the end of @p last, which the material has not forgotten.
    void
    return_to(const LastStep &last);

    /// Lets the residual be what supports and indenter take; other forces are
    /// what an interpolated state lacks for an equilibrium.
    void
    drop_forces_without_support();

    /// Puts the indenter to where the path has it at @p time, sideways, and to
    /// this @p depth.
    void
    place_indenter(const double time, const double depth);

    /// Cells may be flagged for refine(), but the mesh must not be changed.
    Mesh &
    cells_to_flag()
    {
      return mesh;
    }

    /// One value for each active cell of this rank: where the error is large.
    void
    set_error_indicators(const Vector<float> &values)
    {
      indicators = values;
    }

    /// Writes the mesh for a checkpoint, with what is kept in its cells: the
    /// states of the material, and all vectors that the next load step begins
    /// with. @throws FileError
    void
    save(LastStep &last, const std::string &mesh_file);

    /// The mesh becomes the one that has been saved, and the material and
    /// @p last take back what is kept there. Otherwise like reinit().
    /// @throws InputError, FileError
    void
    restore(const std::string &mesh_file,
            const double       time,
            const Load        &load,
            LastStep          &last);

    VectorType
    external_forces_at(const double time) const;

    /// The nodal forces that are in equilibrium with the stresses.
    VectorType
    forces_of_stresses() const;

    /// How far the surface has slipped along the indenter until now, with what
    /// it had at the end of @p last.
    VectorType
    total_slip(const LastStep &last) const;

    std::set<types::boundary_id>
    contact_boundaries() const
    {
      return model.boundary_conditions.ids(BoundaryConditionType::contact);
    }

    /// What the contact amounts to now; this body must outlive it.
    ContactEvaluation<dim>
    contact_evaluation() const
    {
      return {contact_set, u, residual_forces};
    }

    /// The contact surface as it is now.
    ContactSurface<dim>
    contact_surface() const;

    /// The spots in contact.
    ContactZone<dim>
    contact_zone() const;

    const Mesh &
    triangulation() const
    {
      return mesh;
    }

    /// Where the indenter is, sideways.
    const GapFunction<dim> &
    gap_function() const
    {
      return gap;
    }

    const DoFHandler<dim> &
    dof_handler() const
    {
      return unknowns;
    }

    const Supports<dim> &
    supports() const
    {
      return held;
    }

    const SolidOperator<dim> &
    solid() const
    {
      return solid_body;
    }

    const ContactSet<dim> &
    contact() const
    {
      return contact_set;
    }

    const VectorType &
    external_forces() const
    {
      return loads;
    }

    /// The nodal forces in equilibrium with the initial stress.
    const VectorType &
    forces_at_rest() const
    {
      return initial_forces;
    }

    /// What to say of the initial stress and its equilibrium on the present
    /// mesh.
    std::string
    remark_on_initial_stress() const;

    /// What may be expected of the sum of the magnitudes of forces that the
    /// initial stress is made of.
    double
    initial_force_scale() const;

    const VectorType &
    displacement() const
    {
      return u;
    }

    /// The force that the supports and the indenter take from the body; it
    /// vanishes at all other unknowns.
    const VectorType &
    residual() const
    {
      return residual_forces;
    }

    const Vector<float> &
    error_indicators() const
    {
      return indicators;
    }

    const Model<dim>   &model;
    const FESystem<dim> fe;

  private:
    void
    reinit_unknowns(const double time);

    void
    reinit_contact(const double time, const Load &load);

    /// Lets the virgin body bear the initial stress, if there is one: what of
    /// it is not in equilibrium with the supports and loads at t = 0, the
    /// elastic response to that corrects.
    void
    set_initial_stress();

    /// The correction of set_initial_stress(). @return its elastic energy.
    double
    balance_initial_stress(const VectorType &loads_at_rest,
                           const double      energy);

    /// Lets supports, external forces and indenter be those at @p time.
    void
    apply_load(const double time, const Load &load);

    /// Sideways only.
    void
    move_indenter(const double time);

    /// How far the path leads the indenter sideways until @p time.
    Tensor<1, dim - 1>
    sideways_position(const double time) const;

    /// Lets @p newton solve for @p displacement and the set of @p contact.
    NewtonReport
    solve(const SemismoothNewton &newton,
          const LastStep         &last,
          ContactSet<dim>        &contact,
          VectorType             &displacement);

    /// Those of the vectors that save() keeps, with the last solution of the
    /// linear solver, @p response, which helps the next one.
    std::vector<VectorType *>
    fields_to_keep(LastStep &last, VectorType &response);

    // The body, and the indenter above it.
    Mesh             mesh;
    GapFunction<dim> gap;

    // Its unknowns; which of them are constrained or fixed; the body's
    // response; the nodes that may touch the indenter.
    DoFHandler<dim>    unknowns;
    Supports<dim>      held;
    SolidOperator<dim> solid_body;
    ContactSet<dim>    contact_set;

    // Linear algebra.
    std::unique_ptr<TangentSolver> tangent_solver;
    VectorType                     loads;
    VectorType                     u;
    VectorType                     residual_forces;
    VectorType                     initial_forces;
    /// Of the initial stress, as it is given: the part, in the norm of the
    /// elastic energy, that has not been in equilibrium on the present mesh.
    double        initial_imbalance = 0;
    Vector<float> indicators;

    const LinearSolverParameters &linear_solver;
    Log                          &log;
    TimerOutput                  &timer;
  };
} // namespace ElastoPlastic

#endif
