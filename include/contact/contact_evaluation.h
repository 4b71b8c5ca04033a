// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_contact_evaluation_h
#define contact_contact_evaluation_h

#include <optional>

#include "contact/contact_set.h"

namespace ElastoPlastic
{
  /// What the contact of a solution amounts to: areas, pressures and tractions
  /// of the nodes that touch, for tables and fields. Nothing here decides on
  /// the solution.
  ///
  /// A traction is a force over the area on which it acts. Where a contact ends
  /// within faces, nodes that bear a force before the indenter reaches them
  /// hand it to their inner neighbours, and the last ones that it has reached
  /// bear on the touched part of their faces (doc/theory, "The edge of the
  /// contact"). Where the bounds follow the deformation, areas are those of the
  /// present place.
  template <int dim>
  class ContactEvaluation
  {
  public:
    using Vector = typename ContactSet<dim>::Vector;

    /// Of the displacement @p u and the forces @p residual on the indenter, in
    /// the layout of displacements; all three must outlive this object.
    /// Collective.
    ContactEvaluation(const ContactSet<dim> &contact,
                      const Vector          &u,
                      const Vector          &residual);

    /// Collective.
    ContactState
    state() const;

    /// The node with the largest pressure, in the undeformed body. Collective.
    Point<dim>
    place_of_largest_pressure() const;

    /// The nodal forces of the indenter on the body.
    Vector
    forces_on_body() const;

    /// How far the nodes that touch have slipped in the load step: the
    /// displacement of the body relative to the indenter.
    Vector
    slip() const;

    /// Sets the entries of the vertical component at all nodes that the
    /// indenter reaches: the gaps of the deformed surface to the indenter in
    /// its present position, the pressures, and ones at those that touch.
    void
    surface_fields(Vector &gap, Vector &pressure, Vector &active) const;

    /// With friction, at the nodes that touch: sets the shear traction of the
    /// indenter on the body, and ones in the vertical component at those that
    /// stick.
    void
    friction_fields(Vector &shear, Vector &stick) const;

  private:
    using Node = typename ContactSet<dim>::Node;

    /// Which candidates the indenter has reached: those that are closed, and of
    /// the entering ones that are passed those that are inside, or bear force
    /// (beside a sharp tip, some within the contact stay open a little).
    std::vector<bool>
    find_reached() const;

    /// Where areas are measured.
    const ContactFaces<dim> &
    faces() const
    {
      return moved_faces ? *moved_faces : contact.faces;
    }

    /// The lumped areas.
    Vector
    lumped_areas() const;

    /// What each node that is reached has of the touched part of the faces; if
    /// the contact ends at nodes, what each has of them. Collective.
    Vector
    find_touched_areas() const;

    /// The areas on which the forces act that the nodes have been handed. At
    /// the edge they are between touched and lumped ones: such that the
    /// pressure is as close to that of the inner neighbours as it can be.
    /// Collective.
    Vector
    find_bearing_areas() const;

    /// What the candidates bear in normal direction, over the inclination of
    /// the surface, where they bear it. Collective.
    std::vector<double>
    normal_forces() const;

    /// @p values of the candidates, those of nodes not passed handed to inner
    /// neighbours. Collective.
    std::vector<double>
    handed_inside(const std::vector<double> &values) const;

    /// Ones in the vertical component of nodes that are passed.
    Vector
    touched() const;

    /// The pressure at the nodes that are passed; zero elsewhere. Collective.
    Vector
    pressures() const;

    /// Penetration and complementarity of the candidates, of this rank.
    void
    add_distances(ContactState &state) const;

    /// What is not vertical, of this rank.
    void
    add_friction(ContactState &state) const;

    /// Of this rank.
    void
    add_areas(ContactState &state) const;

    const ContactSet<dim> &contact;
    const Vector          &u, &residual;
    /// Of the candidates.
    const std::vector<double> gaps;
    /// EdgeLaw::passed(): these have tractions.
    const std::vector<bool> passed;
    const std::vector<bool> reached;
    /// If areas are those of the deformed body.
    const std::optional<ContactFaces<dim>> moved_faces;
    const Vector                           areas, touched_areas, bearing_areas;
  };
} // namespace ElastoPlastic

#endif
