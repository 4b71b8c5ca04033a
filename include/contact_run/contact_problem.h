// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_run_contact_problem_h
#define contact_run_contact_problem_h

#include <deal.II/base/timer.h>

#include <utility>

#include "contact/contact_set.h"
#include "loads/supports.h"
#include "mechanics/solid_operator.h"
#include "solver/constrained_minimization.h"
#include "solver/tangent_solver.h"

namespace ElastoPlastic
{
  /// The contact problem of one load step on one mesh, put together from its
  /// parts, as SemismoothNewton wants to see it: minimise
  ///
  ///   Pi(u) = int W(strain(u)) dx - forces . u
  ///
  /// where supports and closed contact nodes are constrained; or, if the force
  /// F on the indenter is given,
  ///
  ///   Pi(u, delta) = int W(strain(u)) dx - forces . u - F delta
  ///
  /// where the active contact nodes are coupled: u_i = g_i - delta. Then the
  /// depth delta need not be kept beside u: it can be read from it. With
  /// Coulomb's friction, there is no energy.
  template <int dim>
  class ContactProblem : public ConstrainedMinimization
  {
  public:
    /// All arguments must outlive this object; the active set and the load of
    /// @p contact are those to begin with; the parts of the work are accounted
    /// for in @p timer. An indenter that a force pushes deeper than
    /// @p largest_displacement is taken to sink without end, and a body that
    /// has moved further to give way without end. @p largest_forces is the
    /// largest sum of the magnitudes of all nodal forces in the load history so
    /// far, on whatever mesh.
    ContactProblem(SolidOperator<dim>  &solid,
                   const Supports<dim> &supports,
                   const Vector        &external_forces,
                   ContactSet<dim>     &contact,
                   TangentSolver       &tangent_solver,
                   const double         largest_displacement,
                   const double         largest_forces,
                   TimerOutput         &timer);

    void
    initialize_vector(Vector &vector) const override
    {
      solid.initialize_vector(vector);
    }

    bool
    has_energy() const override
    {
      return solid.has_energy() && !contact.dissipates();
    }

    std::string
    obstacle_to_convexity() const override;

    Energy
    energy(const Vector &u) const override;

    Energy
    compute_residual(Vector &residual, const Vector &u) const override;

    Energy
    move_to(const Vector &u, Vector &residual) override;

    /// The norm of the external forces, or if it is larger, the smallest that
    /// the largest forces of the history can have on this mesh.
    double
    force_scale() const override
    {
      return scale_of_forces;
    }

    void
    linearize(const Vector &u) override;

    /// @throws ConvergenceError if the indenter sinks, or the body gives way,
    /// without end.
    void
    step_taken(const Vector &from, const Vector &to) override;

    void
    apply_tangent(Vector &result, const Vector &increment) const override
    {
      solid.vmult(result, increment);
    }

    unsigned int
    solve_tangent(Vector       &increment,
                  const Vector &rhs,
                  const double  reduction) override;

    double
    slope_along(const Vector &residual, const Vector &increment) const override
    {
      return -(residual * increment) - contact.force() * downward_motion;
    }

    void
    apply_inverse_diagonal(Vector &forces) const override;

    bool
    update_active_set(const Vector &u, const Vector &residual) override;

    bool
    slow_down() override
    {
      return contact.dissipates() &&
             std::exchange(friction_pace, FrictionPace::worst_first) ==
               FrictionPace::all;
    }

    bool
    is_itself() const override
    {
      return !contact.law_is_resting();
    }

    bool
    update_feasible_active_set(const Vector &u,
                               const Vector &residual) override;

    std::uint64_t
    active_set_fingerprint() const override
    {
      return contact.fingerprint();
    }

    unsigned int
    n_active() const override
    {
      return contact.n_active();
    }

    void
    move_constrained(Vector &u) const override;

    void
    return_to_bounds(Vector &u) const override;

    void
    project(Vector &u) const override;

    void
    reduce(Vector &residual) const override;

  private:
    /// Finds out which unknowns are constrained or coupled now, what they share
    /// with others, and the slopes of their bounds.
    void
    collect_unknowns(const Vector &u, const Vector &residual);

    /// Lets a contact that ends within faces end at nodes for some steps, once,
    /// if its edge jumps, or its set does not settle. @return whether the set
    /// is another one for that.
    bool
    change_law(const Vector          &u,
               const Vector          &residual,
               const ActiveSetChange &change);

    /// Pi(u) of a body that has @p stored this energy.
    Energy
    total_energy(const double stored, const Vector &u) const;

    /// Hanging nodes follow their masters.
    void
    distribute(Vector &u) const
    {
      supports.constraints().distribute(u);
    }

    SolidOperator<dim>  &solid;
    const Supports<dim> &supports;
    const Vector        &external_forces;
    ContactSet<dim>     &contact;
    TangentSolver       &tangent_solver;
    const double         largest_displacement;
    const double         scale_of_forces;
    TimerOutput         &timer;

    ReducedUnknowns unknowns;
    /// Where the last step has begun, until its end is linearised; else without
    /// size.
    Vector start_of_step;
    /// Of the right-hand side of the last linear system.
    double       previous_norm  = 0;
    unsigned int n_changes      = 0;
    bool         law_has_rested = false;
    FrictionPace friction_pace  = FrictionPace::all;
    /// Of the indenter, in the last increment; zero if its depth is given.
    double downward_motion = 0;
  };
} // namespace ElastoPlastic

#endif
