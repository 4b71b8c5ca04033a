// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_gap_function_h
#define contact_gap_function_h

#include "contact/indenter.h"

namespace ElastoPlastic
{
  /// The gap function g of doc/theory.md, "Johnson's formulation": an indenter
  /// that stands above the body. The last coordinate points up.
  template <int dim>
  class GapFunction
  {
  public:
    /// @param surface_height is the last coordinate of the highest point of
    /// the contact surface.
    GapFunction(const PlacedIndenter<dim> &indenter,
                const double               surface_height);

    bool
    has_indenter() const;

    /// The horizontal position of the indenter.
    const Point<dim - 1> &
    position() const;

    /// The vertical distance from the point @p p of the undeformed body up to
    /// the undisplaced indenter; +infinity outside Gamma_0, where the indenter
    /// does not reach.
    double
    value(const Point<dim> &p) const;

  private:
    const PlacedIndenter<dim> indenter;
    const double              tip_height;
  };
} // namespace ElastoPlastic

#endif
