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
#include "base/sloped_bound.h"
#include "contact/contact_geometry.h"
#include "contact/contact_state.h"
#include "contact/coulomb_friction.h"
#include "contact/divided_edge.h"
#include "loading/load.h"

namespace ElastoPlastic
{
  using namespace dealii;

  template <int dim>
  class ContactEvaluation;



  /// The nodes of the contact surface that the indenter can reach, and which
  /// of them touch it.
  ///
  /// A candidate is a vertical degree of freedom i on the contact boundary
  /// with a finite gap g_i, that is neither held by a support nor a hanging
  /// node. It is bounded by u_i <= g_i - depth, where g_i may depend on the
  /// horizontal displacements of the node (ContactBounds): then its force has a
  /// horizontal part as well. Its pressure is p_i = r_i/D_i, where r_i is the
  /// residual (the force on the indenter) and D_i the entry of the lumped
  /// boundary mass, the integral of the node's shape function.
  /// Hanging nodes follow their masters; their D and r are handed to the
  /// masters with the same weights, so that sums of forces stay exact.
  ///
  /// As long as divide_edge() is in force, the contact ends within faces. A
  /// node k at its edge is then bounded by u_k <= g_k - depth + sum_j t_kj (g_j
  /// - depth - u_j), with the open nodes j of its faces; they get the parts
  /// t_kj of its nodal force (doc/theory.md, "The edge of the contact").
  ///
  /// With friction, a node that sticks to the indenter keeps the place on it
  /// where it was at the beginning of the load step, and a node that slips has
  /// the horizontal force of Coulomb's law: then forces follow from the
  /// vertical ones with a slope of their own (CoulombFriction). Where a support
  /// holds a horizontal displacement, there is no friction in that direction.
  ///
  /// All vectors passed in have the partition of the one passed to reinit().
  template <int dim>
  class ContactSet
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    explicit ContactSet(
      const ContactBounds<dim>   &bounds,
      const Kinematics            kinematics = Kinematics::cartesian,
      const EdgeRule              rule       = EdgeRule::at_nodes,
      const CoulombFriction<dim> &friction   = CoulombFriction<dim>(0., 1.));

    /// Finds the candidates. @p supported_dofs are no candidates;
    /// @p layout gives the partition of vectors.
    void
    reinit(const DoFHandler<dim>              &dof_handler,
           const AffineConstraints<double>    &constraints,
           const std::set<types::boundary_id> &contact_boundaries,
           const IndexSet                     &supported_dofs,
           const Vector                       &layout);

    /// The indenter has moved sideways: finds out what it can reach now.
    /// Active nodes stay active. Collective.
    void
    follow_indenter();

    /// A load step begins with the displacement @p u, and the indenter will
    /// move sideways by @p motion: where nodes that stick will go.
    void
    begin_step(const Vector &u, const Tensor<1, dim - 1> &motion);

    /// Drives the indenter: to a depth, or by a force F, which leaves it where
    /// it is until a displacement says how far it has moved.
    void
    set_load(const Load &load);

    /// Puts the indenter to @p depth; and where it is.
    void
    place(const double depth);
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

    /// Lets the contact end where it is expected when the indenter will be at
    /// @p expected_depth, until the next call; at nodes, if it has only a few.
    /// As long as the indenter is not deeper than it has been, the edge stays
    /// divided as it is. Collective.
    void
    divide_edge(const double expected_depth);

    /// Lets it end at nodes. Collective.
    void
    unite_edge();

    /// Divides the edge as edge_memory() says, after a checkpoint. Collective.
    void
    restore_edge();

    /// A load step has ended with the displacement @p u: notes how far away the
    /// nodes are. Collective.
    void
    note_edge(const Vector &u);

    /// What note_edge() has noted on this mesh, which divide_edge() needs
    /// beside the active set.
    EdgeMemory &
    edge_memory()
    {
      return edge.edge_memory();
    }

    /// Null if the contact ends at nodes.
    const std::shared_ptr<const SharedRows> &
    shared_rows() const
    {
      return edge.rows();
    }

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

    /// On all ranks together. Collective.
    unsigned int
    n_candidates() const;
    unsigned int
    n_active() const;

    /// The smallest gap of all candidates, and of the nodes without area;
    /// infinite if there is none. Collective.
    double
    min_gap() const;
    double
    min_gap_without_area() const;

    /// Sets the active entries of @p u to g - depth, but for rounding errors.
    void
    move_active(Vector &u) const;

    /// Whether bounds depend on horizontal displacements, or forces have
    /// horizontal parts.
    bool
    has_sloped_bounds() const
    {
      return bounds.are_sloped() || friction.exists();
    }

    bool
    has_friction() const
    {
      return friction.exists();
    }

    /// Whether friction takes energy.
    bool
    dissipates() const
    {
      return friction.dissipates();
    }

    /// Whether a motion along the bounds to first order leaves them.
    bool
    has_curved_bounds() const
    {
      return bounds.follow_deformation();
    }

    /// The same as move_active() for an indenter where @p u says that it is.
    void
    return_to_bounds(Vector &u) const;

    /// The bounds of all nodes that bear a part of the force, if they depend on
    /// other unknowns.
    std::vector<SlopedBound>
    sloped_bounds(const Vector &u, const Vector &residual) const;

    /// Lowers the entries of @p u that exceed g - depth.
    void
    project(Vector &u) const;

    /// The indices of the active nodes of this rank in vectors, and those of
    /// all their unknowns on which the indenter exerts a force.
    std::vector<unsigned int>
    active_entries() const;
    std::vector<unsigned int>
    force_entries() const;

    /// The indices of the nodes without area that @p u brings into an indenter
    /// which ought to press, but touches no candidate. Collective.
    std::vector<unsigned int>
    entries_entered(const Vector &u) const;

    /// Those of the horizontal displacements that friction holds.
    std::vector<unsigned int>
    stuck_entries() const;

    /// Sets @p value at the entries of all candidates.
    void
    set_candidate_entries(Vector &vector, const double value) const;

    /// The vertical nodal forces of the indenter on the body.
    Vector
    vertical_forces_on_body(const Vector &residual) const;

  private:
    /// (It reads what is below.)
    friend class ContactEvaluation<dim>;

    using Node = ContactCandidate<dim>;

    /// An indenter that no force pushes does not press on any node, and has
    /// none to tell it its place: it follows the body without holding it.
    bool
    presses() const
    {
      return !is_force_driven() || force() > 0.;
    }

    /// Those of the nodes that the indenter reaches.
    void
    find_candidates();

    /// How far a node has slipped in the load step, and where no support holds
    /// it.
    TangentVector<dim>
    slip(const Node &node, const Vector &u) const;

    /// Whether friction holds the horizontal displacement @p d of a node.
    bool
    is_held(const Node &node, const unsigned int d) const;

    /// The force of a node on the indenter.
    ContactForce<dim>
    contact_force(const Node                 &node,
                  const IndenterSurface<dim> &surface,
                  const Vector               &residual) const;

    /// Its normal part, as the vertical force that would have it without
    /// friction.
    double
    pressing_force(const Node   &node,
                   const Vector &u,
                   const Vector &residual) const;

    /// By how much the force of a node on the indenter is larger than that on
    /// itself: by what it shares with others.
    double
    share(const Node &node) const;

    /// Whether a node that has come into contact sticks at first.
    void
    begin_friction(Node &node, const Vector &u) const;

    /// Finds out which of the active nodes stick. @return whether any does on
    /// any rank that did not before, or the other way round.
    bool
    update_friction(const Vector &u, const Vector &residual);

    SlopedBound
    sloped_bound(const Node &node, const Vector &u) const;

    double
    bound(const Node &node, const Vector &u) const;

    void
    move_active_to(Vector &u, const double depth) const;

    /// sum_j t_kj (g_j - depth - u_j); empty without shared rows.
    Vector
    shared_gaps(const Vector &u, const double depth) const;

    /// Where that puts a node: its bound is so much higher.
    static double
    shift(const Vector &shared_gaps, const Node &node)
    {
      return shared_gaps.size() > 0 ? shared_gaps.local_element(node.index) :
                                      0.;
    }

    /// Which candidates touch, as DividedEdge wants it.
    Vector
    kinds() const;

    /// The distances of the candidates from an indenter at @p depth.
    Vector
    distances(const Vector &u, const double depth) const;

    /// Their lumped areas.
    Vector
    areas() const;

    /// The shared rows of the present active set.
    void
    share_rows();

    /// The smallest distance from the undisplaced indenter down to those of
    /// @p some nodes that are candidates or without area. Collective.
    double
    nearest_distance(const std::vector<Node> &some, const Vector &u) const;

    /// If a force F > 0 has no active node to press on, moves the indenter to
    /// the nearest candidates and activates them. @return whether it has.
    bool
    find_contact(const Vector &u);

    /// Sets the active flag of all candidates; @p u says where nodes are that
    /// become active. @return whether any flag has changed on any rank.
    template <typename Predicate>
    bool
    set_active(const Vector &u, const Predicate &is_active);

    ContactBounds<dim>         bounds;
    const Kinematics           kinematics;
    const EdgeRule             rule;
    const CoulombFriction<dim> friction;
    double                     present_depth = 0;
    std::optional<double>      given_force;
    MPI_Comm                   communicator;
    types::global_dof_index    first_owned_dof = 0;

    // All; those within the reach of the indenter, but for hanging ones; these.
    std::vector<Node> nodes;
    std::vector<Node> candidates;
    std::vector<Node> hanging_nodes;

    // Of a contact that ends within faces; and, with friction, the parts of
    // their forces that the nodes share.
    DividedEdge<dim> edge;
    Vector           shared_parts;
  };
} // namespace ElastoPlastic

#endif
