// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mesh_simplex_h
#define bounds_mesh_simplex_h

#include <deal.II/base/point.h>

#include <array>

// A simplex is a triangle in the plane and a tetrahedron in space; its faces
// are sides or triangles. Here is how both number what they consist of: the
// only place where they differ in that.

namespace ElastoPlastic
{
  using namespace dealii;

  /// The corners of a simplex; those of a triangle are in positive orientation.
  template <int dim>
  using Corners = std::array<Point<dim>, dim + 1>;

  template <int dim>
  using FaceCorners = std::array<Point<dim>, dim>;

  /// The coordinates of a point of a simplex, or with one dimension less of a
  /// face, by which it is the mean of the corners.
  template <int dim>
  using Barycentric = std::array<double, dim + 1>;

  /// Corner @p i of a simplex.
  template <int dim>
  Barycentric<dim>
  corner_position(const unsigned int i)
  {
    Barycentric<dim> position = {};
    position[i]               = 1.;
    return position;
  }



  /// The corner of a simplex that is corner @p i of its face @p k: face k of a
  /// triangle goes from corner k on to the next one, that of a tetrahedron is
  /// opposite to corner k.
  template <int dim>
  constexpr unsigned int
  corner_of_face(const unsigned int k, const unsigned int i)
  {
    return dim == 2 ? (k + i) % 3 : (i < k ? i : i + 1);
  }

  /// The corner that is not one of face @p k.
  template <int dim>
  constexpr unsigned int
  opposite_corner(const unsigned int k)
  {
    return dim == 2 ? (k + 2) % 3 : k;
  }

  /// The centre of gravity divides a simplex into parts, of which part @p k has
  /// the face k: the centre takes the place of the opposite corner. The place
  /// of a @p corner of the simplex among those of the part: part k of a
  /// triangle begins with corner k, so that its centre comes last.
  template <int dim>
  constexpr unsigned int
  place_in_part(const unsigned int k, const unsigned int corner)
  {
    return dim == 2 ? (corner + 3 - k) % 3 : corner;
  }

  template <int dim>
  constexpr unsigned int
  place_of_centre(const unsigned int k)
  {
    return place_in_part<dim>(k, opposite_corner<dim>(k));
  }



  template <int dim>
  constexpr unsigned int edges_per_simplex = dim *(dim + 1) / 2;

  /// The two corners between which an @p edge is. Those of a triangle are its
  /// faces.
  template <int dim>
  constexpr std::array<unsigned int, 2>
  ends_of_edge(const unsigned int edge)
  {
    if (dim < 3)
      return {{edge, (edge + 1) % (dim + 1)}};
    const unsigned int first = edge < 3 ? 0 : edge < 5 ? 1 : 2;
    return {{first, first == 0 ? edge + 1 : first == 1 ? edge - 1 : 3}};
  }

  /// The edge that joins two corners.
  template <int dim>
  constexpr unsigned int
  edge_between(const unsigned int i, const unsigned int j)
  {
    unsigned int edge = 0;
    while (ends_of_edge<dim>(edge)[0] + ends_of_edge<dim>(edge)[1] != i + j ||
           (ends_of_edge<dim>(edge)[0] != i && ends_of_edge<dim>(edge)[1] != i))
      ++edge;
    return edge;
  }



  /// Its mean with the weights @p position of @p values at corners.
  template <typename Value, std::size_t n>
  Value
  interpolate(const std::array<double, n> &position,
              const std::array<Value, n>  &values)
  {
    Value result = position[0] * values[0];
    for (unsigned int i = 1; i < n; ++i)
      result += position[i] * values[i];
    return result;
  }

  /// The same of points in barycentric coordinates.
  template <std::size_t n, std::size_t m>
  std::array<double, m>
  interpolate(const std::array<double, n>                &position,
              const std::array<std::array<double, m>, n> &points)
  {
    std::array<double, m> result = {};
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < m; ++j)
        result[j] += position[i] * points[i][j];
    return result;
  }

  /// The point of a simplex that has these coordinates in its part @p k.
  template <int dim>
  Barycentric<dim>
  point_of_part(const unsigned int k, const Barycentric<dim> &in_part)
  {
    Barycentric<dim> point;
    point.fill(in_part[place_of_centre<dim>(k)] / (dim + 1.));
    for (unsigned int i = 0; i <= dim; ++i)
      if (i != opposite_corner<dim>(k))
        point[i] += in_part[place_in_part<dim>(k, i)];
    return point;
  }

  /// The centre of gravity of a simplex or a face with these @p corners.
  template <int dim, std::size_t n>
  Point<dim>
  centre_of(const std::array<Point<dim>, n> &corners)
  {
    Tensor<1, dim> sum = corners[0];
    for (unsigned int i = 1; i < n; ++i)
      sum += corners[i];
    return Point<dim>(sum / double(n));
  }

  /// The values at the corners of part @p k of a function that is linear on the
  /// simplex, and has these @p values at its corners.
  template <int dim, typename Value>
  std::array<Value, dim + 1>
  on_part(const std::array<Value, dim + 1> &values, const unsigned int k)
  {
    std::array<Value, dim + 1> result;
    Value                      sum = values[0];
    for (unsigned int i = 1; i <= dim; ++i)
      sum += values[i];
    for (unsigned int i = 0; i <= dim; ++i)
      result[place_in_part<dim>(k, i)] = values[i];
    result[place_of_centre<dim>(k)] = sum / (dim + 1.);
    return result;
  }

  /// The area of a triangle, negative if its orientation is, or the volume of a
  /// tetrahedron.
  double
  volume(const Corners<2> &corners);
  double
  volume(const Corners<3> &corners);

  /// The length of a side, or the area of a triangle.
  double
  area(const FaceCorners<2> &corners);
  double
  area(const FaceCorners<3> &corners);

  /// A unit vector: that of a side points to its right, seen from the first end
  /// to the second, out of a triangle that has it as a face.
  Tensor<1, 2>
  normal(const FaceCorners<2> &corners);
  Tensor<1, 3>
  normal(const FaceCorners<3> &corners);

  /// Unit vectors at right angles to each other and to the normal; that of a
  /// side has its direction.
  std::array<Tensor<1, 2>, 1>
  tangents(const FaceCorners<2> &corners);
  std::array<Tensor<1, 3>, 2>
  tangents(const FaceCorners<3> &corners);

  /// The gradients of the linear functions that are 1 at one corner and 0 at
  /// the others: they point away from the opposite faces.
  std::array<Tensor<1, 2>, 3>
  gradients(const Corners<2> &corners);
  std::array<Tensor<1, 3>, 4>
  gradients(const Corners<3> &corners);
} // namespace ElastoPlastic

#endif
