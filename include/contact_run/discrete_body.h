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
#include "contact/gap_function.h"
#include "contact_run/contact_problem.h"
#include "contact_run/last_step.h"
#include "evaluation/contact_surface.h"
#include "loads/supports.h"
#include "mechanics/solid_operator.h"
#include "output/log.h"
#include "problem/model.h"
#include "restart/saved_mesh.h"
#include "solver/linear_solver_parameters.h"
#include "solver/tangent_solver.h"

namespace ElastoPlastic
{
  /// The body of a Model on its present mesh: what holds it, what it does, the
  /// nodes that may touch the indenter, and where it is. Whatever depends on
  /// the mesh is here, in the order in which it is made; reinit() makes all of
  /// it, and nothing else does.
  ///
  /// All functions are collective, and all vectors have the layout of the
  /// present mesh.
  template <int dim>
  struct DiscreteBody
  {
    /// Makes the first mesh, without unknowns. All arguments must outlive this
    /// object. @throws InputError
    DiscreteBody(const Model<dim>             &model,
                 const LinearSolverParameters &linear_solver,
                 const MPI_Comm                communicator,
                 Log                          &log,
                 TimerOutput                  &timer);

    /// Prepares everything that depends on the mesh, for the end of a load step
    /// at @p time, with this @p load of the indenter. The displacement is zero,
    /// the material is virgin.
    void
    reinit(const double time, const Load &load);

    /// Obeys the flags of the triangulation, and takes the displacement and the
    /// states of the material to the new mesh, with what of @p last_step the
    /// next step is guessed from. Otherwise like reinit().
    void
    refine(const double time, const Load &load, LastStep &last_step);

    /// Lets supports, external forces and indenter be those at @p time.
    void
    apply_load(const double time, const Load &load);

    /// To where the path has it at @p time; sideways only.
    void
    move_indenter(const double time);

    /// How far the path leads it sideways until then.
    Tensor<1, dim - 1>
    sideways_position(const double time) const;

    VectorType
    external_forces_at(const double time) const;

    /// The nodal forces that are in equilibrium with the stresses.
    VectorType
    forces_of_stresses() const;

    /// How far the surface has slipped along the indenter until now, with what
    /// it had at the end of @p last_step.
    VectorType
    total_slip(const LastStep &last_step) const;

    /// What SemismoothNewton is to solve, with this @p contact set. For
    /// @p largest_forces see ContactProblem.
    ContactProblem<dim>
    problem_with(ContactSet<dim> &contact, const double largest_forces);

    std::set<types::boundary_id>
    contact_boundaries() const;

    /// What the contact amounts to now; this body must outlive it. Collective.
    ContactEvaluation<dim>
    contact_evaluation() const;

    /// The contact surface as it is now.
    ContactSurface<dim>
    contact_surface() const;

    /// The spots in contact.
    ContactZone<dim>
    contact_zone() const;

    /// Writes the mesh for a checkpoint, with what is kept in its cells: the
    /// states of the material, and all vectors that the next load step begins
    /// with. Collective. @throws FileError
    void
    save(LastStep &last_step, const std::string &mesh_file);

    /// Takes them back on the mesh that has been saved. Collective.
    /// @throws InputError, FileError
    void
    take_back(SavedMesh<dim> &saved, LastStep &last_step);

    // The body, and the indenter above it.
    const Model<dim>                         &model;
    parallel::distributed::Triangulation<dim> triangulation;
    GapFunction<dim>                          gap_function;

    // The finite element space; which of its unknowns are constrained or fixed;
    // the body's response; the nodes that may touch the indenter.
    const FESystem<dim> fe;
    DoFHandler<dim>     dof_handler;
    Supports<dim>       supports;
    SolidOperator<dim>  solid;
    ContactSet<dim>     contact;

    // Linear algebra. The residual is the force that the supports and the
    // indenter take from the body; it vanishes at all other unknowns.
    std::unique_ptr<TangentSolver> tangent_solver;
    VectorType                     external_forces;
    VectorType                     displacement;
    VectorType                     residual;

    // One value for each active cell of this rank: where the error is large.
    Vector<float> error_indicators;

  private:
    void
    reinit_unknowns(const double time);

    void
    reinit_contact(const double time, const Load &load);

    /// Those of the vectors that save() keeps, with the last
    /// solution of the linear solver, @p response, which helps the next one.
    std::vector<VectorType *>
    fields_to_keep(LastStep &last_step, VectorType &response);

    const LinearSolverParameters &linear_solver;
    Log                          &log;
    TimerOutput                  &timer;
  };
} // namespace ElastoPlastic

#endif
