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
  /// The gap g between a face and the indenter, enclosed by two functions,
  ///   lower <= g <= upper,
  /// that are linear on many small simplices of the face.
  ///
  /// If g is convex, this is certain. Of other functions it is true if they
  /// change between convex and concave at no more than some of the small
  /// simplices.
  template <int dim>
  class FaceGap;



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



  /// On a side, the bounds join values at equidistant points of the part that
  /// the indenter reaches, all less the same distance, or more. A convex
  /// function does not exceed its chords, and between two points it is not
  /// below the continuations of the chords beside them.
  template <>
  class FaceGap<2>
  {
  public:
    /// In so many intervals is the reached part divided.
    static constexpr unsigned int n_intervals = 1024;

    /// @p gap is infinite where the indenter does not reach, which must not be
    /// between two points that it does.
    FaceGap(const std::function<double(const Point<2> &)> &gap,
            const FaceCorners<2>                          &corners);

    std::vector<SmallSimplex<2>>
    small_simplices() const;

    /// At an end of the side; infinite if it is more than rounding away from
    /// what the indenter reaches.
    double
    lower_at_corner(const unsigned int corner) const;

  private:
    /// One of the points, as a position between the ends of the side.
    double
    position(const unsigned int i) const
    {
      return begin + (end - begin) * i / n_intervals;
    }

    double              begin = 0, end = 1; ///< of what the indenter reaches
    std::vector<double> values; ///< g at the n_intervals + 1 points, or empty
    double              below = 0, above = 0;
  };



  /// On a triangle, the small ones are those of a regular lattice. A convex
  /// function does not exceed the linear function between its values at the
  /// corners of a small triangle, and what that function becomes in the point
  /// reflection about a lattice point c encloses it from below, g(x) >= 2 g(c)
  /// - g(2c - x). The best of some c is taken.
  template <>
  class FaceGap<3>
  {
  public:
    /// So many small triangles are there along an edge.
    static constexpr int n_intervals = 32;

    /// @p gap is infinite where the indenter does not reach; it is evaluated in
    /// the plane of the face, beyond its edges, too.
    /// @throws ConvergenceError if the indenter reaches so little of the face
    /// that nothing bounds the gap from below.
    FaceGap(const std::function<double(const Point<3> &)> &gap,
            const FaceCorners<3>                          &corners);

    /// All, n_intervals^2.
    std::vector<SmallSimplex<3>>
    small_simplices() const;

    /// At a corner of the face.
    double
    lower_at_corner(const unsigned int corner) const
    {
      return lower[index(
        {corner == 1 ? n_intervals : 0, corner == 2 ? n_intervals : 0})];
    }

  private:
    /// A point of the lattice: so many steps to corner 1 and to corner 2.
    struct LatticePoint
    {
      int i, j;
    };

    using Values = std::vector<double>;

    /// How many steps beyond the face g is known.
    static constexpr int margin = 5;

    /// Of the arrays of values.
    static std::size_t
    index(const LatticePoint &point)
    {
      return (n_intervals + 2 * margin + 1) * (margin + point.i) + margin +
             point.j;
    }

    /// Runs @p action on the corners of all small triangles.
    template <typename Action>
    static void
    for_small_triangles(const Action &action);

    /// Encloses g on a small triangle.
    void
    enclose(const std::array<LatticePoint, 3> &corners);

    Values gap, lower, upper;
  };
} // namespace ElastoPlastic

#endif
