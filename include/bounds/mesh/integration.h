// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mesh_integration_h
#define bounds_mesh_integration_h

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Runs @p action(t, x, weight) for the points x of a quadrature of the side
  /// from @p a to @p b, 0 < t < 1 being their positions between the two. The
  /// weights add up to 1: they are relative to the length of the side.
  /// Polynomials of degree 9 or less are integrated exactly.
  template <typename Action>
  void
  integrate_on_side(const Point<2> &a, const Point<2> &b, const Action &action)
  {
    static const QGauss<1> quadrature(5);
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const double t = quadrature.point(q)[0];
        action(t, Point<2>(a + t * (b - a)), quadrature.weight(q));
      }
  }



  /// Runs @p action(t, x) for both ends of the side from @p a to @p b and for
  /// points x between them, at the positions t: so many, and at such distances,
  /// that a function is not taken for the polynomial with which it agrees where
  /// a mesh or a quadrature looks at it.
  template <typename Action>
  void
  look_along_side(const Point<2> &a, const Point<2> &b, const Action &action)
  {
    static const QGauss<1> inside(16);
    action(0., a);
    for (const Point<1> &t : inside.get_points())
      action(t[0], Point<2>(a + t[0] * (b - a)));
    action(1., b);
  }



  /// A point of a triangle and its weight in a quadrature.
  struct WeightedPoint
  {
    std::array<double, 3> position; ///< in barycentric coordinates
    double                weight;   ///< relative to the area

    /// The value of the linear function with these @p values at the corners.
    template <typename Value>
    Value
    interpolate(const std::array<Value, 3> &values) const
    {
      return position[0] * values[0] + position[1] * values[1] +
             position[2] * values[2];
    }
  };



  /// A quadrature of int f(x) / r(x) dx over a triangle, r being linear with
  /// the values @p r at the corners, positive but for corners on an axis, where
  /// it is zero. It is exact if f / r is a polynomial of degree 4 or less. It
  /// is never too small, and little too large, if f is the square of a
  /// polynomial of degree 2 or less that is zero on the axis, or a positive
  /// quadratic form of such polynomials (doc/theory, "Guaranteed error").
  std::vector<WeightedPoint>
  quadrature_over(const std::array<double, 3> &r);
} // namespace ElastoPlastic

#endif
