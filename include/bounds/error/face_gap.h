// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_error_face_gap_h
#define bounds_error_face_gap_h

#include <array>
#include <functional>
#include <vector>

#include "bounds/mesh/simplex.h"

namespace ElastoPlastic
{
  /// A part of a face on which the bounds of the gap are linear.
  template <int dim>
  struct SmallSimplex
  {
    /// The corners, in barycentric coordinates of the face.
    std::array<Barycentric<dim - 1>, dim> corners;
    std::array<double, dim> lower; ///< at the corners; infinite where the
                                   ///< indenter does not reach
    std::array<double, dim> upper; ///< likewise
    double                  part;  ///< of the area of the face
  };



  /// The gap g between a face and the indenter, enclosed by two functions,
  ///   lower <= g <= upper,
  /// that are linear on many small simplices of the face.
  ///
  /// If g is convex, this is certain. Of other functions it is true if they
  /// change between convex and concave at no more than some of the small
  /// simplices.
  ///
  /// On a side, the bounds join values at equidistant points of the part that
  /// the indenter reaches, all less the same distance, or more. A convex
  /// function does not exceed its chords, and between two points it is not
  /// below the continuations of the chords beside them.
  ///
  /// On a triangle, the small ones are those of a regular lattice. A convex
  /// function does not exceed the linear function between its values at the
  /// corners of a small triangle, and what that function becomes in the point
  /// reflection about a lattice point c encloses it from below, g(x) >= 2 g(c)
  /// - g(2c - x). The best of some c is taken.
  template <int dim>
  struct FaceGap
  {
    /// In so many intervals is the reached part of a side divided, or an edge
    /// of a triangle.
    static constexpr int n_intervals = dim == 2 ? 1024 : 32;

    /// @p gap is infinite where the indenter does not reach, which on a side
    /// must not be between two points that it does; in space, it is evaluated
    /// in the plane of the face, beyond its edges, too.
    /// @throws ConvergenceError if the indenter reaches so little of a face in
    /// space that nothing bounds the gap from below.
    FaceGap(const std::function<double(const Point<dim> &)> &gap,
            const FaceCorners<dim>                          &corners);

    /// All of the reached part of a side, or all n_intervals^2 of a triangle.
    std::vector<SmallSimplex<dim>> small_simplices;

    /// At a corner of the face; infinite if it is more than rounding away from
    /// what the indenter reaches.
    std::array<double, dim> lower_at_corners;
  };

  template <>
  FaceGap<2>::FaceGap(const std::function<double(const Point<2> &)> &gap,
                      const FaceCorners<2>                          &corners);
  template <>
  FaceGap<3>::FaceGap(const std::function<double(const Point<3> &)> &gap,
                      const FaceCorners<3>                          &corners);
} // namespace ElastoPlastic

#endif
