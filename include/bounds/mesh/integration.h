// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mesh_integration_h
#define bounds_mesh_integration_h

#include <vector>

#include "bounds/mesh/simplex.h"

namespace ElastoPlastic
{
  /// A point of a simplex of dim dimensions and its weight in a quadrature.
  template <int dim>
  struct WeightedPoint
  {
    Barycentric<dim> position;
    double           weight; ///< relative to the size of the simplex
  };

  /// A quadrature that is exact for polynomials of the degree 3 or less, or on
  /// a triangle 5 or less.
  template <int dim>
  const std::vector<WeightedPoint<dim>> &
  simplex_quadrature();



  /// A point of a face.
  template <int dim>
  struct FacePoint
  {
    Barycentric<dim - 1> position;
    Point<dim>           x;
  };

  template <int dim>
  FacePoint<dim>
  point_on_face(const FaceCorners<dim>     &corners,
                const Barycentric<dim - 1> &position)
  {
    Tensor<1, dim> x = corners[0];
    for (unsigned int i = 1; i < dim; ++i)
      x += position[i] * (corners[i] - corners[0]);
    return {position, Point<dim>(x)};
  }

  /// A corner of a face.
  template <int dim>
  FacePoint<dim>
  corner_point(const FaceCorners<dim> &corners, const unsigned int i)
  {
    return {corner_position<dim - 1>(i), corners[i]};
  }

  /// The points for integrate_on_face(), and those between the corners for
  /// look_over_face().
  template <int dim>
  const std::vector<WeightedPoint<dim - 1>> &
  face_quadrature();
  template <int dim>
  const std::vector<WeightedPoint<dim - 1>> &
  points_over_face();



  /// Runs @p action(point, weight) for the points of a quadrature of a face.
  /// The weights add up to 1: they are relative to its area. Polynomials are
  /// integrated exactly, of degree 9 or less on a side, 7 on a triangle.
  template <int dim, typename Action>
  void
  integrate_on_face(const FaceCorners<dim> &corners, const Action &action)
  {
    for (const auto &[position, weight] : face_quadrature<dim>())
      action(point_on_face<dim>(corners, position), weight);
  }



  /// Runs @p action(point) for the corners of a face and for points between
  /// them: so many, and at such distances, that a function is not taken for the
  /// polynomial with which it agrees where a mesh or a quadrature looks at it.
  template <int dim, typename Action>
  void
  look_over_face(const FaceCorners<dim> &corners, const Action &action)
  {
    for (unsigned int i = 0; i < dim; ++i)
      action(corner_point<dim>(corners, i));
    for (const auto &[position, weight] : points_over_face<dim>())
      action(point_on_face<dim>(corners, position));
  }



  /// A quadrature of int f(x) / r(x) dx over a triangle, r being linear with
  /// the values @p r at the corners, positive but for corners on an axis, where
  /// it is zero. It is exact if f / r is a polynomial of degree 4 or less. It
  /// is never too small, and little too large, if f is the square of a
  /// polynomial of degree 2 or less that is zero on the axis, or a positive
  /// quadratic form of such polynomials (doc/theory, "Guaranteed error").
  std::vector<WeightedPoint<2>>
  quadrature_over(const std::array<double, 3> &r);
} // namespace ElastoPlastic

#endif
