// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_contact_set_h
#define contact_contact_set_h

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "base/kinematics.h"
#include "base/sloped_bound.h"
#include "contact/contact_faces.h"
#include "contact/contact_geometry.h"
#include "contact/contact_state.h"
#include "contact/coulomb_friction.h"
#include "contact/edge_law.h"
#include "contact/face_filter.h"
#include "loading/loading_parameters.h"

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
  /// A contact that ends within faces has closed nodes, which are bounded by
  /// u_k <= g_k - depth + allowance_k, and at its edge nodes that are entering:
  /// they bear force as well, both kinds are active (EdgeLaw).
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

    /// A load step begins with the displacement @p u and the indenter at @p
    /// depth, and it will move sideways by @p motion: where nodes that stick
    /// will go. Collective.
    void
    begin_step(const Vector             &u,
               const double              depth,
               const Tensor<1, dim - 1> &motion);

    /// Of nodes that never slip: @p u is the solution if in this load step
    /// nothing new sticks, and nothing gets free. From it follows what sticks,
    /// and where. @return whether the solution then is another. Collective.
    bool
    find_sticking(const Vector &u, const Vector &residual);

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
    is_force_driven() const;

    /// F; zero if a depth drives the indenter.
    double
    force() const;

    /// Where the indenter is when the body has the displacement @p u, in which
    /// the closed nodes, if a force drives them, have moved together: the mean
    /// of g - u + allowance over them is that depth. Collective.
    double
    depth_at(const Vector &u) const;

    /// Puts a force driven indenter to where it is according to @p u: on the
    /// closed nodes, or if there is none, to where it just touches the body.
    void
    settle(const Vector &u);

    /// Takes those candidates as closed, too, that @p u brings to the indenter
    /// or beyond, and as entering those that it brings near it. If there is
    /// none, a force F > 0 moves the indenter to the nearest; if F = 0, there
    /// are none.
    void
    activate_touching(const Vector &u);

    /// Finds out which nodes are entering at @p u; takes none as active.
    /// Collective.
    void
    find_entering(const Vector &u);
    void
    deactivate_all();

    /// Lets the contact end at nodes, or within faces again. Collective.
    void
    rest_law();
    void
    wake_law();
    bool
    law_is_resting() const;

    /// What the nodes at the edge share where the body has the displacement
    /// @p u, with the forces @p residual; nothing if the contact ends at nodes.
    /// Collective.
    SharedForces
    shared_forces(const Vector &u, const Vector &residual) const;

    /// The primal-dual switching test: closed nodes stay if they press, more
    /// than their share of what presses inside; others follow from where they
    /// are. A force F > 0 that has lost all of them moves the indenter to the
    /// nearest.
    ActiveSetChange
    update(const Vector      &u,
           const Vector      &residual,
           const FrictionPace pace = FrictionPace::all);

    /// The same but for friction.
    ActiveSetChange
    update_statuses(const Vector &u, const Vector &residual);

    /// The same for a feasible @p u: closed are those that touch and press.
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
    unsigned int
    n_closed() const;

    /// The smallest gap of all candidates, and of the nodes without area;
    /// infinite if there is none. Collective.
    double
    min_gap() const;
    double
    min_gap_without_area() const;

    /// Sets the closed entries of @p u to their bounds, but for rounding
    /// errors.
    void
    move_active(Vector &u) const;

    /// Whether bounds depend on horizontal displacements, or forces have
    /// horizontal parts.
    bool
    has_sloped_bounds() const;

    bool
    has_friction() const;

    /// Whether friction takes energy.
    bool
    dissipates() const;

    /// Whether its edge moves through the faces now.
    bool
    ends_within_faces() const;

    /// Whether a motion along the bounds to first order leaves them.
    bool
    has_curved_bounds() const;

    /// The same as move_active() for an indenter where @p u says that it is.
    void
    return_to_bounds(Vector &u) const;

    /// The bounds of all nodes that bear a part of the force, if they depend on
    /// other unknowns.
    std::vector<SlopedBound>
    sloped_bounds(const Vector &u, const Vector &residual) const;

    /// Lowers the entries of @p u that exceed their bounds.
    void
    project(Vector &u) const;

    /// The indices of the active nodes of this rank in vectors, of those that
    /// are closed, of all unknowns on which the indenter exerts a force, and of
    /// the horizontal ones that friction holds.
    std::vector<unsigned int>
    active_entries() const;
    std::vector<unsigned int>
    closed_entries() const;
    std::vector<unsigned int>
    force_entries() const;
    std::vector<unsigned int>
    stuck_entries() const;

    /// The indices of the nodes without area that @p u brings into an indenter
    /// which ought to press, but touches no candidate. Collective.
    std::vector<unsigned int>
    entries_entered(const Vector &u) const;

    /// Sets @p value at the entries of all candidates.
    void
    set_candidate_entries(Vector &vector, const double value) const;

    /// The vertical nodal forces of the indenter on the body.
    Vector
    vertical_forces_on_body(const Vector &residual) const;

  private:
    friend class ContactEvaluation<dim>;

    using Node = ContactCandidate<dim>;

    /// An indenter that no force pushes does not press on any node, and has
    /// none to tell it its place: it follows the body without holding it.
    bool
    presses() const;

    /// The law in force.
    const EdgeLaw &
    law() const
    {
      return law_rests ? no_law : edge_law;
    }

    /// Those that the indenter reaches, and the edge between them. Collective.
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

    /// Whether a node that has come into contact sticks at first.
    void
    begin_friction(Node &node, const Vector &u) const;

    /// Finds out which active nodes stick. @return whether it has changed.
    bool
    update_friction(const Vector      &u,
                    const Vector      &residual,
                    const FrictionPace pace);

    /// How its horizontal force follows from the vertical one; whatever a skew
    /// plane of symmetry ties. @throws ConvergenceError as CoulombFriction
    ForceSlope<dim>
    force_law(const Node                 &node,
              const IndenterSurface<dim> &surface,
              const Vector               &u) const;

    SlopedBound
    sloped_bound(const Node &node, const Vector &u) const;

    double
    bound(const Node &node, const Vector &u) const
    {
      return bounds.value(node, u) - present_depth;
    }

    void
    move_closed_to(Vector &u, const double depth) const;

    /// Of the candidates, the distances of the undisplaced indenter, and of one
    /// at @p depth.
    std::vector<double>
    heights(const Vector &u) const;
    std::vector<double>
    gaps(const Vector &u, const double depth) const;

    std::vector<ContactStatus>
    statuses() const;

    /// What presses inside of each candidate (EdgeLaw::forces_inside()).
    /// Collective.
    std::vector<double>
    forces_inside(const Vector &residual) const;

    /// Whether the candidate number @p k presses as much as a closed one does:
    /// by itself with @p pressing, vertically with @p force.
    bool
    stays_closed(const unsigned int k,
                 const double       pressing,
                 const double       force,
                 const double       force_inside) const;

    /// The smallest distance from the undisplaced indenter down to those of
    /// @p some nodes that are candidates or without area. Collective.
    double
    nearest_distance(const std::vector<Node> &some, const Vector &u) const;

    /// If a force F > 0 has no closed node to press on, moves the indenter to
    /// the nearest candidates and activates them. @return whether it has.
    bool
    find_contact(const Vector &u);

    /// Where no node is closed, none is entering: there is no force to share.
    void
    open_without_closed();

    /// Sets the status of all candidates to what status(number, node) says; @p
    /// u says where nodes are that become active. @return whether any status
    /// has changed on any rank.
    template <typename Status>
    bool
    set_statuses(const Vector &u, const Status &status);

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

    ContactFaces<dim>          faces;
    FaceFilter<dim>            filter;
    std::vector<EdgeLaw::Pair> neighbors;
    EdgeLaw                    edge_law;
    const EdgeLaw              no_law;
    bool                       law_rests = false;
  };
} // namespace ElastoPlastic

#endif
