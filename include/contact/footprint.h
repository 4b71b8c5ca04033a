// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_footprint_h
#define contact_footprint_h

#include <deal.II/base/point.h>

#include <array>
#include <optional>

#include "mesh/disc.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A rectangle in the horizontal plane, parallel to the axes; an interval if
  /// there is a single horizontal direction.
  template <int dim>
  struct Rectangle
  {
    Point<dim>              centre;
    std::array<double, dim> half_widths; ///< may be infinite
  };



  /// All that an indenter can touch, seen from above, as far as it is known:
  /// what is in both the disc and the rectangle, if there are any.
  template <int dim>
  struct Footprint
  {
    std::optional<Disc<dim>>      disc;
    std::optional<Rectangle<dim>> rectangle;

    bool
    is_known() const
    {
      return disc || rectangle;
    }
  };



  /// Whether the indenter can touch all of a straight side of a section, or of
  /// a triangle in space: exactly, but for rounding.
  bool
  contains(const Footprint<1> &footprint, const std::array<Point<2>, 2> &side);
  bool
  contains(const Footprint<2>            &footprint,
           const std::array<Point<3>, 3> &triangle);

  /// Whether it can touch more than the edge of it. Exactly, but for rounding,
  /// if there is not both a disc and a rectangle; then it may also be one that
  /// has points in common with each of them.
  bool
  overlaps(const Footprint<1> &footprint, const std::array<Point<2>, 2> &side);
  bool
  overlaps(const Footprint<2>            &footprint,
           const std::array<Point<3>, 3> &triangle);
} // namespace ElastoPlastic

#endif
