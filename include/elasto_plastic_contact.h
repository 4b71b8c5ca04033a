// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef elasto_plastic_contact_h
#define elasto_plastic_contact_h

#include <deal.II/base/timer.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>

#include <memory>

#include "contact/contact_set.h"
#include "contact/gap_function.h"
#include "io/field_output.h"
#include "io/parameters.h"
#include "io/screen.h"
#include "io/statistics.h"
#include "mechanics/solid_operator.h"
#include "mechanics/supports.h"
#include "mesh/boundary_conditions.h"
#include "mesh/geometry.h"
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
  /// penetrate the indenter: u_d <= g - delta.
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
    /// anything is computed or written.
    /// @throws InputError
    ElastoPlasticContact(const Parameters &parameters,
                         const MPI_Comm    communicator);

    /// Solves the problem on one mesh after the other and writes the results
    /// to the output directory. @p overwrite allows to replace earlier ones.
    /// @throws InputError, ConvergenceError, FileError
    void
    run(const bool overwrite);

  private:
    // The outline, in the order of run() (core.cc):
    void
    solve_on_mesh_sequence(Statistics &statistics);

    // One mesh (setup.cc): after any change of the mesh, setup_body() and
    // setup_contact() prepare everything that depends on it, and
    // check_supports() makes sure that the body cannot float away.
    void
    setup_body();
    void
    setup_contact();
    void
    check_supports() const;
    void
    check_reach() const;

    // One solve (solve.cc): contact and plasticity in one Newton loop, and
    // what its solution says.
    SolveResult
    solve(const unsigned int cycle);
    void
    evaluate_contact(SolveResult &result);
    void
    evaluate_plasticity(SolveResult &result) const;
    double
    vertical_reaction() const;

    // The next mesh (refinement.cc).
    void
    estimate_error();
    void
    refine_mesh();

    // Results (core.cc).
    void
    output_results(const unsigned int cycle);

    /// Gap of the undeformed body, for the contact surface as it is.
    GapFunction<dim>
    make_gap_function() const;

    // The problem as the user has described it.
    const Parameters parameters;
    const MPI_Comm   communicator;

    // What tells the user about it.
    mutable Screen      screen;
    mutable TimerOutput timer;
    FieldOutput<dim>    field_output;

    // The body's shape and boundary conditions, and the indenter above it.
    parallel::distributed::Triangulation<dim> triangulation;
    const BoundaryNames                       boundary_names;
    const BoundaryConditions<dim>             boundary_conditions;
    const GapFunction<dim>                    gap_function;

    // The finite element space; which of its unknowns are constrained or
    // fixed; the body's response; the nodes that may touch the indenter.
    const FESystem<dim>                 fe;
    DoFHandler<dim>                     dof_handler;
    Supports<dim>                       supports;
    std::unique_ptr<SolidOperator<dim>> solid;
    ContactSet<dim>                     contact;

    // Linear algebra. The residual is the force that the supports and the
    // indenter take from the body; it vanishes at all other unknowns.
    std::unique_ptr<TangentSolver<dim>> tangent_solver;
    VectorType                          external_forces;
    VectorType                          displacement;
    VectorType                          residual;
    Vector<float>                       error_indicators;
  };
} // namespace ElastoPlastic

#endif
