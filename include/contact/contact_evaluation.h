// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_contact_evaluation_h
#define contact_contact_evaluation_h

#include "contact/contact_set.h"

namespace ElastoPlastic
{
  /// What the contact of a solution amounts to: areas, pressures and tractions
  /// of the nodes that touch, for tables and fields. Nothing here decides on
  /// the solution.
  ///
  /// Without friction, a pressure is the force of a node over the area on which
  /// it presses; a contact that ends within faces has areas of its own
  /// (doc/theory.md, "The edge of the contact"). Where the bounds follow the
  /// deformation, areas are those of the present place.
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

    /// The areas on which the nodes would press.
    Vector
    pressed_areas() const;

    /// Which candidates are closed, as ContactFaces wants it.
    Vector
    kinds() const;

    /// The pressure at the active nodes; zero elsewhere.
    Vector
    pressures() const;

    /// What each closed node has of the touched part of the faces; if the
    /// contact ends at nodes, what each has of them. Collective.
    Vector
    touched_areas() const;

    /// Penetration and complementarity of the candidates, of this rank.
    void
    add_distances(ContactState &state) const;

    /// What is not vertical, of this rank.
    void
    add_friction(ContactState &state) const;

    /// Of this rank. Collective.
    void
    add_areas(ContactState &state) const;

    const ContactSet<dim> &contact;
    const Vector          &u, &residual;
    const Vector           areas;
  };
} // namespace ElastoPlastic

#endif
