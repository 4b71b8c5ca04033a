// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_contact_set_h
#define contact_contact_set_h

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "base/kinematics.h"
#include "loading/load.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The contact quantities of a solution, summed over all ranks.
  struct ContactState
  {
    /// Sum of the nodal forces, positive when the indenter presses.
    double force = 0;
    /// Sum of the lumped areas of the active nodes.
    double area         = 0;
    double max_pressure = 0;
    /// The smallest pressure of an active node: negative would be tension.
    double       min_pressure = 0;
    unsigned int n_active     = 0;
    /// max(u_d - (g - depth), 0) over the candidates.
    double max_penetration = 0;
    /// The same over the hanging nodes, which follow their masters.
    double max_hanging_penetration = 0;
    /// sum |force * distance| / (total force * |depth|) over the candidates.
    double complementarity_error = 0;
  };



  /// The nodes of the contact surface that the indenter can reach, and which
  /// of them touch it.
  ///
  /// A candidate is a vertical degree of freedom i on the contact boundary
  /// with a finite gap g_i, that is neither held by a support nor a hanging
  /// node. It is bounded by u_i <= g_i - depth. Its pressure is p_i = r_i/D_i,
  /// where r_i is the residual (the force on the indenter) and D_i the entry of
  /// the lumped boundary mass, the integral of the node's shape function.
  /// Hanging nodes follow their masters; their D and r are handed to the
  /// masters with the same weights, so that sums of forces stay exact.
  ///
  /// All vectors passed in have the partition of the one passed to reinit().
  template <int dim>
  class ContactSet
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// @p gap(x) is the vertical distance from x up to the undisplaced
    /// indenter, infinite where it does not reach.
    explicit ContactSet(const std::function<double(const Point<dim> &)> &gap,
                        const Kinematics kinematics = Kinematics::cartesian);

    /// Finds the candidates. @p supported_dofs are no candidates;
    /// @p layout gives the partition of vectors.
    void
    reinit(const DoFHandler<dim>              &dof_handler,
           const AffineConstraints<double>    &constraints,
           const std::set<types::boundary_id> &contact_boundaries,
           const IndexSet                     &supported_dofs,
           const Vector                       &layout);

    /// Drives the indenter: to a depth, or by a force F, which leaves it where
    /// it is until a displacement says how far it has moved.
    void
    set_load(const Load &load);

    /// Puts the indenter to @p depth.
    void
    place(const double depth);

    /// Where the indenter is.
    double
    depth() const
    {
      return present_depth;
    }

    bool
    is_force_driven() const
    {
      return given_force.has_value();
    }

    /// F; zero if a depth drives the indenter.
    double
    force() const
    {
      return given_force.value_or(0.);
    }

    /// Where the indenter is when the body has the displacement @p u, in which
    /// the active nodes, if a force drives them, have moved together: the mean
    /// of g - u over them.
    double
    depth_at(const Vector &u) const;

    /// Puts a force driven indenter to where it is according to @p u: on the
    /// active nodes, or if there is none, to where it just touches the body.
    void
    settle(const Vector &u);

    /// Takes those candidates as active, too, that @p u brings to the indenter
    /// or beyond. If there is none, a force F > 0 moves the indenter to the
    /// nearest; if F = 0, there are none.
    void
    activate_touching(const Vector &u);

    /// Takes none as active.
    void
    deactivate_all();

    /// The primal-dual switching test with lambda = 0 off the active set:
    /// active nodes stay if they press, others join if they penetrate. A force
    /// F > 0 that has lost all of them moves the indenter to the nearest.
    /// @return whether the set has changed on any rank.
    bool
    update(const Vector &u, const Vector &residual);

    /// The active set of a feasible @p u: candidates that touch and press.
    /// @return whether the set has changed on any rank.
    bool
    update_feasible(const Vector &u, const Vector &residual);

    /// A number that tells active sets apart; the same on all ranks.
    std::uint64_t
    fingerprint() const;

    /// On all ranks together.
    unsigned int
    n_candidates() const;

    /// On all ranks together.
    unsigned int
    n_active() const;

    /// The smallest gap of all candidates; infinite if there is none.
    double
    min_gap() const;

    /// Sets the active entries of @p u to g - depth, but for rounding errors.
    void
    move_active(Vector &u) const;

    /// Lowers the entries of @p u that exceed g - depth.
    void
    project(Vector &u) const;

    /// The indices of the active nodes of this rank in vectors.
    std::vector<unsigned int>
    active_entries() const;

    /// Sets @p value at the entries of all candidates.
    void
    set_candidate_entries(Vector &vector, const double value) const;

    ContactState
    state(const Vector &u, const Vector &residual) const;

    /// For output: the surface fields, in the vertical component of vectors in
    /// the layout of displacements; zero elsewhere. Gaps are those of the
    /// deformed surface to the indenter in its present position.
    void
    surface_fields(Vector       &gap,
                   Vector       &pressure,
                   Vector       &active,
                   const Vector &u,
                   const Vector &residual) const;

  private:
    /// A node within the indenter's reach. Indices are local to this rank.
    struct Node
    {
      unsigned int index;
      double       gap;
      double       area;
      bool         active;
    };

    /// An indenter that no force pushes does not press on any node, and has
    /// none to tell it its place: it follows the body without holding it.
    bool
    presses() const
    {
      return !is_force_driven() || force() > 0.;
    }

    double
    bound(const Node &node) const
    {
      return node.gap - present_depth;
    }

    /// The smallest distance from the undisplaced indenter down to a candidate.
    double
    nearest_distance(const Vector &u) const;

    /// If a force F > 0 has no active node to press on, moves the indenter to
    /// the nearest candidates and activates them. @return whether it has.
    bool
    find_contact(const Vector &u);

    /// Sets the active flag of all candidates. @return whether any flag has
    /// changed on any rank.
    template <typename Predicate>
    bool
    set_active(const Predicate &is_active);

    const std::function<double(const Point<dim> &)> gap;
    const Kinematics                                kinematics;
    double                                          present_depth = 0;
    std::optional<double>                           given_force;
    MPI_Comm                                        communicator;
    types::global_dof_index                         first_owned_dof = 0;

    std::vector<Node> candidates;
    std::vector<Node> hanging_nodes;
  };
} // namespace ElastoPlastic

#endif
