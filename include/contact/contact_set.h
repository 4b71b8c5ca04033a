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
#include <set>
#include <vector>

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
    explicit ContactSet(const std::function<double(const Point<dim> &)> &gap);

    /// Finds the candidates. @p supported_dofs are no candidates;
    /// @p layout gives the partition of vectors.
    void
    reinit(const DoFHandler<dim>              &dof_handler,
           const AffineConstraints<double>    &constraints,
           const std::set<types::boundary_id> &contact_boundaries,
           const IndexSet                     &supported_dofs,
           const Vector                       &layout);

    /// Pushes the indenter to @p depth.
    void
    set_depth(const double depth);

    /// Takes those candidates as active that @p u brings to the indenter or
    /// beyond.
    void
    activate_touching(const Vector &u);

    /// The primal-dual switching test with lambda = 0 off the active set:
    /// active nodes stay if they press, others join if they penetrate.
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

    /// Sets the active entries of @p u to g - depth.
    void
    move_active(Vector &u) const;

    /// Lowers the entries of @p u that exceed g - depth.
    void
    project(Vector &u) const;

    /// Sets @p value at the active entries of @p vector.
    void
    set_active_entries(Vector &vector, const double value) const;

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

    double
    bound(const Node &node) const;

    /// Sets the active flag of all candidates. @return whether any flag has
    /// changed on any rank.
    template <typename Predicate>
    bool
    set_active(const Predicate &is_active);

    void
    find_nodes(const DoFHandler<dim>              &dof_handler,
               const AffineConstraints<double>    &constraints,
               const std::set<types::boundary_id> &contact_boundaries,
               const IndexSet                     &supported_dofs,
               const Vector                       &area);

    const std::function<double(const Point<dim> &)> gap;
    double                                          depth = 0;
    MPI_Comm                                        communicator;
    types::global_dof_index                         first_owned_dof = 0;

    std::vector<Node> candidates;
    std::vector<Node> hanging_nodes;
  };
} // namespace ElastoPlastic

#endif
