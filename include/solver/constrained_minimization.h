// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_constrained_minimization_h
#define solver_constrained_minimization_h

#include <deal.II/lac/la_parallel_vector.h>

#include <string>

namespace ElastoPlastic
{
  using namespace dealii;

  /// An energy, and the sum of the magnitudes of the parts that it has been
  /// added up from: what is small against that may be rounding.
  struct Energy
  {
    double value     = 0;
    double magnitude = 0;
  };



  /// What SemismoothNewton needs to know of a problem: minimise an energy
  /// Pi(u), which should be convex, where some unknowns are constrained (by
  /// supports, or because they are in the active set) and others are bounded
  /// from above (the contact candidates). The derivative of Pi is called
  /// -residual, so that the residual at a constrained unknown is the force its
  /// support takes from the body.
  ///
  /// If the forces have no energy, the problem is the system of equations and
  /// inequalities that a minimum would satisfy: the same, but for energy(),
  /// and with a second derivative that is not symmetric.
  ///
  /// The place of the bounds may be an unknown itself, with a given force that
  /// pushes them: then the active unknowns are not constrained, but coupled,
  /// and one of them stands for all in reduced vectors; see ReducedUnknowns.
  class ConstrainedMinimization
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    virtual ~ConstrainedMinimization() = default;

    virtual void
    initialize_vector(Vector &vector) const = 0;

    /// Whether Pi exists.
    virtual bool
    has_energy() const = 0;

    /// What prevents Pi, or the bounds, from being convex, as a user knows it;
    /// empty if nothing does: then a descent on the admissible set finds the
    /// minimum.
    virtual std::string
    obstacle_to_convexity() const = 0;

    bool
    is_convex() const
    {
      return obstacle_to_convexity().empty();
    }

    /// Pi(u), or a number to look at if it does not exist.
    virtual Energy
    energy(const Vector &u) const = 0;

    /// -dPi/du at all unknowns, constrained ones included. @return energy(),
    /// which the same work yields.
    virtual Energy
    compute_residual(Vector &residual, const Vector &u) const = 0;

    /// The same, and the bounds, if they depend on u, and their slopes are
    /// those at this one from now on.
    virtual Energy
    move_to(const Vector &u, Vector &residual)
    {
      return compute_residual(residual, u);
    }

    /// A norm of forces, of the problem and not of any u, which is not zero
    /// where the residual of the solution is: forces that are small against it
    /// are negligible.
    virtual double
    force_scale() const = 0;

    /// Stores the second derivative of Pi at u, or (if Pi exists) a positive
    /// definite approximation that tends to it when the iteration converges,
    /// for apply_tangent(), solve_tangent() and apply_inverse_diagonal().
    virtual void
    linearize(const Vector &u) = 0;

    /// The iteration has moved on. A problem whose linearize() depends on more
    /// unknowns than u may update them.
    virtual void
    step_taken(const Vector &from, const Vector &to) = 0;

    /// The product of the stored second derivative with @p increment.
    virtual void
    apply_tangent(Vector &result, const Vector &increment) const = 0;

    /// Solves tangent * increment = rhs, a reduced vector, on the unknowns that
    /// can move, with zero at the constrained ones, until the linear residual
    /// has fallen by @p reduction. The increment is an expanded vector.
    /// @return the number of iterations.
    virtual unsigned int
    solve_tangent(Vector       &increment,
                  const Vector &rhs,
                  const double  reduction) = 0;

    /// The derivative of Pi where it has this @p residual, along the last
    /// @p increment of solve_tangent().
    virtual double
    slope_along(const Vector &residual, const Vector &increment) const = 0;

    /// Divides reduced @p forces by an approximation, positive, of the diagonal
    /// of the stored second derivative, and expands the result.
    virtual void
    apply_inverse_diagonal(Vector &forces) const = 0;

    /// The switching test of the primal-dual active set method.
    /// @return whether the set has changed.
    virtual bool
    update_active_set(const Vector &u, const Vector &residual) = 0;

    /// The set comes back again and again: less of it changes at once from now
    /// on. @return false if that cannot be, or is so already.
    virtual bool
    slow_down()
    {
      return false;
    }

    /// Whether the set is that of the problem itself, and not of a simpler one
    /// on the way to it.
    virtual bool
    is_itself() const = 0;

    /// The active set of a feasible method: the candidates that touch their
    /// bound and press against it.
    /// @return whether the set has changed.
    virtual bool
    update_feasible_active_set(const Vector &u, const Vector &residual) = 0;

    /// A number that tells active sets apart, the same on all ranks.
    virtual std::uint64_t
    active_set_fingerprint() const = 0;

    /// The number of active candidates on all ranks.
    virtual unsigned int
    n_active() const = 0;

    /// Moves the constrained unknowns of u to their prescribed places.
    virtual void
    move_constrained(Vector &u) const = 0;

    /// Where a step along the tangents of curved bounds has left them: moves
    /// the active unknowns of u back.
    virtual void
    return_to_bounds(Vector &u) const = 0;

    /// Moves the candidates of u that violate their bound onto it.
    virtual void
    project(Vector &u) const = 0;

    /// Turns the residual at all unknowns into the reduced vector -dPi/du of
    /// the unknowns that can move; zero at the constrained ones.
    virtual void
    reduce(Vector &residual) const = 0;
  };
} // namespace ElastoPlastic

#endif
