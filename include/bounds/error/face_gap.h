// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_error_face_gap_h
#define bounds_error_face_gap_h

#include <array>
#include <functional>
#include <vector>

#include "bounds/mesh/tetrahedral_mesh.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The gap g between a triangular face and the indenter, enclosed by two
  /// functions,
  ///   lower <= g <= upper,
  /// that are linear on the small triangles of a regular lattice: what SideGap
  /// is in two dimensions.
  ///
  /// If g is convex, this is certain: it does not exceed the linear function
  /// between its values at the corners of a small triangle, and what that
  /// function becomes in the point reflection about a lattice point c encloses
  /// it from below, g(x) >= 2 g(c) - g(2c - x). The best of some c is taken.
  /// Of other functions it is true if they change between convex and concave at
  /// no more than some of the small triangles.
  class FaceGap
  {
  public:
    /// So many small triangles are there along an edge.
    static constexpr int n_intervals = 32;

    /// @p gap is infinite where the indenter does not reach; it is evaluated in
    /// the plane of the face, beyond its edges, too.
    /// @throws ConvergenceError if the indenter reaches so little of the face
    /// that nothing bounds the gap from below.
    FaceGap(const std::function<double(const Point<3> &)> &gap,
            const TriangleFace                            &corners);

    struct SmallTriangle
    {
      /// The corners, in barycentric coordinates of the face.
      std::array<std::array<double, 3>, 3> corners;
      std::array<double, 3> lower; ///< at the corners; infinite where the
                                   ///< indenter does not reach
      std::array<double, 3> upper; ///< likewise

      /// The point with these barycentric coordinates, in those of the face.
      std::array<double, 3>
      position(const std::array<double, 3> &coordinates) const;
    };

    /// All, n_intervals^2.
    std::vector<SmallTriangle>
    small_triangles() const;

    /// At a corner of the face.
    double
    lower_at_corner(const unsigned int corner) const;

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
    index(const LatticePoint &point);

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
