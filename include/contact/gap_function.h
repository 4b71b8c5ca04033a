// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_gap_function_h
#define contact_gap_function_h

#include "contact/footprint.h"
#include "indenter/indenter.h"

namespace ElastoPlastic
{
  /// The gap function g of doc/theory, "Johnson's formulation": an indenter
  /// that stands above the body. The last coordinate points up.
  template <int dim>
  class GapFunction
  {
  public:
    /// @param surface_height is the last coordinate of the highest point of
    /// the contact surface; see Indenter::surface_for() for @p body_size.
    GapFunction(const PlacedIndenter<dim> &indenter,
                const double               surface_height,
                const double               body_size)
      : indenter(indenter)
      , tip_height(surface_height + indenter.initial_gap)
      , body_size(body_size)
      , present_position(indenter.position)
    {}


    bool
    has_indenter() const
    {
      return indenter.shape != nullptr;
    }

    /// Moves the indenter sideways to this distance from where it has been put.
    void
    move_to(const Tensor<1, dim - 1> &displacement)
    {
      present_position = indenter.position + displacement;
    }

    /// The horizontal position of the indenter.
    const Point<dim - 1> &
    position() const
    {
      return present_position;
    }

    /// The vertical distance from the point @p p of the undeformed body up to
    /// the undisplaced indenter; +infinity outside Gamma_0, where the indenter
    /// does not reach.
    double
    value(const Point<dim> &p) const;

    /// Gamma_0 seen from above.
    Footprint<dim - 1>
    footprint() const;

    /// The gap at @p p, and its derivatives with respect to the horizontal
    /// coordinates: the slope and curvature of the indenter above p, zero
    /// where the gap is infinite.
    IndenterSurface<dim>
    surface(const Point<dim> &p) const
    {
      return surface_for(p, p);
    }

    /// The same at the present place @p p of a node that was at @p origin in
    /// the undeformed body (Indenter::surface_for()).
    IndenterSurface<dim>
    surface_for(const Point<dim> &origin, const Point<dim> &p) const;

  private:
    /// From the tip to @p p, horizontally.
    Point<dim - 1>
    offset(const Point<dim> &p) const;

    /// Whether contact is looked for at an offset from the tip.
    bool
    reaches(const Point<dim - 1> &offset) const
    {
      return has_indenter() && within(offset.norm(), indenter.reach);
    }

    const PlacedIndenter<dim> indenter;
    const double              tip_height;
    const double              body_size;
    Point<dim - 1>            present_position;
  };
} // namespace ElastoPlastic

#endif
