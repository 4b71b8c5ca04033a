// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_contact_geometry_h
#define contact_contact_geometry_h

#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>
#include <functional>

#include "base/enum_names.h"
#include "contact/contact_nodes.h"

namespace ElastoPlastic
{
  /// Where a node meets the indenter, and in which direction it is pushed
  /// (doc/theory, "The geometry of the contact").
  enum class ContactGeometry
  {
    automatic, ///< present with finite strains; else normal or vertical,
               ///< depending on whether the contact surface is curved or flat
    vertical,  ///< above its place in the undeformed body; downwards
    normal,    ///< above that place, but on the tangent plane of the indenter
               ///< there; along the normal of that
    present    ///< above its present place; along the normal of the indenter
  };

  template <>
  inline const EnumNames<ContactGeometry> enum_names<ContactGeometry> = {
    {"automatic", ContactGeometry::automatic},
    {"vertical", ContactGeometry::vertical},
    {"normal", ContactGeometry::normal},
    {"present", ContactGeometry::present}};



  /// The bounds of the vertical displacements of contact nodes as functions of
  /// their horizontal ones, for an indenter at depth 0.
  template <int dim>
  class ContactBounds
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;
    using Gap    = std::function<IndenterSurface<dim>(const Point<dim> &origin,
                                                   const Point<dim> &place)>;

    /// @p gap is GapFunction::surface_for(). @p geometry is not automatic.
    ContactBounds(const Gap &gap, const ContactGeometry geometry)
      : gap(gap)
      , geometry(geometry)
    {
      Assert(geometry != ContactGeometry::automatic, ExcInternalError());
    }

    /// Whether the indenter is met at the present places of the nodes.
    bool
    follow_deformation() const
    {
      return geometry == ContactGeometry::present;
    }

    /// Whether the indenter reaches a node: it is above the node, and where a
    /// bound depends on its flank, that is no wall beside the node.
    bool
    reach(const ContactNode<dim> &node) const;

    /// Whether they depend on the horizontal displacements.
    bool
    are_sloped() const
    {
      return geometry != ContactGeometry::vertical;
    }

    /// The gap in the undeformed body.
    IndenterSurface<dim>
    undeformed_gap(const Point<dim> &point) const
    {
      return gap(point, point);
    }

    double
    value(const ContactNode<dim> &node, const Vector &u) const
    {
      return surface(node, u).height;
    }

    /// The bound and its derivatives with respect to the horizontal
    /// displacements: the surface of the indenter that the node meets.
    IndenterSurface<dim>
    surface(const ContactNode<dim> &node, const Vector &u) const;

    /// How much larger the force on a node is than its vertical part, if
    /// pressures refer to areas of the undeformed surface.
    double
    inclination(const ContactNode<dim> &node) const
    {
      return geometry == ContactGeometry::normal ?
               std::sqrt(1. + node.gap.slope.norm_square()) :
               1.;
    }

  private:
    /// A node that has slid off the end of the indenter, or to where an
    /// expression has no value, is below what it was below in the undeformed
    /// body.
    IndenterSurface<dim>
    gap_at_present_place(const ContactNode<dim> &node, const Vector &u) const;

    const Gap             gap;
    const ContactGeometry geometry;
  };



  /// Those of an indenter of which nothing but the @p gap is known.
  template <int dim>
  ContactBounds<dim>
  vertical_bounds(const std::function<double(const Point<dim> &)> &gap)
  {
    return ContactBounds<dim>(
      [gap](const Point<dim> &x, const Point<dim> &) {
        return IndenterSurface<dim>{gap(x), {}, {}};
      },
      ContactGeometry::vertical);
  }
} // namespace ElastoPlastic

#endif
