// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_integration_h
#define equilibrium_integration_h

#include <deal.II/base/quadrature_lib.h>

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



  /// The integral of the product of the linear functions that are 1 at the
  /// corners @p i and @p j of a triangle, relative to its area.
  constexpr double
  mass_of_corners(const unsigned int i, const unsigned int j)
  {
    return i == j ? 1. / 6. : 1. / 12.;
  }



  /// The integral of the product of two linear functions over a triangle,
  /// relative to its area. @p product(i, j) is that of the value of the first
  /// at corner i and of the second at corner j.
  template <typename Product>
  double
  integrate_product(const Product &product)
  {
    double sum = 0;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        sum += mass_of_corners(i, j) * product(i, j);
    return sum;
  }
} // namespace ElastoPlastic

#endif
