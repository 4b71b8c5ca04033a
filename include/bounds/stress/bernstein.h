// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_bernstein_h
#define bounds_stress_bernstein_h

#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

/// Bernstein's bases of polynomials on a triangle and on a side. They are not
/// negative and add up to 1: so a convex function of a polynomial is nowhere
/// more than the same combination of its values for the coefficients, and the
/// polynomial is 1 or more if they are. See @cite lai_schumaker_2007.
namespace ElastoPlastic::Bernstein
{
  using namespace dealii;

  /// Barycentric coordinates of a point in a triangle.
  using Barycentric = std::array<double, 3>;

  /// Of one function at a point: by the coordinates x and y.
  struct Jet
  {
    double       value;
    Tensor<1, 2> gradient;
    Tensor<2, 2> hessian;
  };

  /// Of the barycentric coordinates in a function. Those of a degree add up to
  /// it.
  using Exponents = std::array<int, 3>;

  constexpr unsigned int
  n_functions(const unsigned int degree)
  {
    return (degree + 1) * (degree + 2) / 2;
  }

  /// The functions of a @p degree (at most 2) in their order: those of the
  /// corners, then those of the middles of the sides.
  const std::vector<Exponents> &
  exponents(const unsigned int degree);

  /// The number of a function among those of its degree (at most 2).
  unsigned int
  number_of(const Exponents &exponents);

  /// The point that a function, which must not be constant, belongs to.
  Barycentric
  point_of(const Exponents &exponents);

  /// The functions of a @p degree (at most 2) at a point.
  std::vector<double>
  functions(const unsigned int degree, const Barycentric &point);

  constexpr unsigned int n_cubics = 10;

  /// The cubic functions belong, in this order, to the three corners, to two
  /// points on each side k, the first of which is close to corner k, and to
  /// the centre of gravity.
  std::array<Jet, n_cubics>
  cubics(const std::array<Tensor<1, 2>, 3> &gradients,
         const Barycentric                 &point);

  /// The points that the cubic functions belong to.
  const std::array<Barycentric, n_cubics> &
  cubic_points();

  /// The corners of a triangle, and the middles of its sides.
  constexpr unsigned int n_quadratics = 6;
  const std::array<Barycentric, n_quadratics> &
  quadratic_points();

  /// The integrals of the quadratic functions times a linear function with
  /// these @p values at the corners, over a triangle of area 1.
  std::array<double, n_quadratics>
  quadratic_moments(const std::array<double, 3> &values);

  /// The coefficients (n x n) of a polynomial on a triangle with values at the
  /// cubic_points() or quadratic_points().
  const FullMatrix<double> &
  cubic_coefficients();
  const FullMatrix<double> &
  quadratic_coefficients();

  /// Those of a polynomial of a @p degree (at most 4) on a side with values at
  /// degree + 1 equidistant points, from end to end.
  const FullMatrix<double> &
  side_coefficients(const unsigned int degree);

  /// The functions of a @p degree at a position 0 <= @p t <= 1 of a side.
  std::vector<double>
  side_functions(const unsigned int degree, const double t);

  /// What turns the moments int f B dt of a polynomial f of a @p degree (1 or
  /// 2) on a side into its coefficients.
  const FullMatrix<double> &
  side_coefficients_of_moments(const unsigned int degree);
} // namespace ElastoPlastic::Bernstein

#endif
