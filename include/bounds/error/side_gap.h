// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_error_side_gap_h
#define bounds_error_side_gap_h

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The gap g(t) between a side and the indenter, enclosed by piecewise linear
  /// functions, 0 <= t <= 1 being the position between the ends of the side:
  ///   chord(t) - below <= g(t) <= chord(t) + above,
  /// where chord(t) joins the values at equidistant points of the part of the
  /// side that the indenter reaches, begin <= t <= end.
  ///
  /// If g is convex, this is certain: a convex function does not exceed its
  /// chords (above is zero), and between two points it is not below
  /// the continuations of the chords beside them. Of other functions it is true
  /// if they change between convex and concave at no more than
  /// some of the points.
  struct SideGap
  {
    /// In so many intervals is the reached part divided.
    static constexpr unsigned int n_intervals = 1024;

    /// Of the side from @p a to @p b. @p gap is infinite where the indenter
    /// does not reach, which must not be between two points that it does.
    SideGap(const std::function<double(const Point<2> &)> &gap,
            const Point<2>                                &a,
            const Point<2>                                &b);

    /// The position of one of the points.
    double
    position(const unsigned int i) const;

    double begin = 0;
    double end   = 1;
    /// g at the n_intervals + 1 points; empty if the indenter does not reach
    /// the side.
    std::vector<double> values;
    double              below = 0;
    double              above = 0;
  };
} // namespace ElastoPlastic

#endif
