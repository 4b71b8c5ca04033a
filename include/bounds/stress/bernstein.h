// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_bernstein_h
#define bounds_stress_bernstein_h

#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

#include "bounds/mesh/simplex.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Bernstein's bases of polynomials of any degree on a simplex of dim
  /// dimensions: a side, a triangle or a tetrahedron. They are not negative and
  /// add up to 1: so a convex function of a polynomial is nowhere more than the
  /// same combination of its values for the coefficients, and the polynomial is
  /// 1 or more if they are. See @cite lai_schumaker_2007.
  template <int dim>
  struct Bernstein
  {
    /// Of the barycentric coordinates in a function. Those of a degree add up
    /// to it.
    using Exponents = std::array<int, dim + 1>;

    static constexpr unsigned int
    n_functions(const unsigned int degree)
    {
      unsigned int n = 1;
      for (unsigned int i = 1; i <= dim; ++i)
        n = n * (degree + i) / i;
      return n;
    }

    /// The functions of a @p degree (at most 4) in their order: on a side, from
    /// end to end; else those of the corners, then those on the edges, each
    /// from end to end, then the others.
    static const std::vector<Exponents> &
    exponents(const unsigned int degree);

    /// The number of a function among those of its degree.
    static unsigned int
    number_of(const Exponents &exponents);

    /// The point that a function, which must not be constant, belongs to.
    static Barycentric<dim>
    point_of(const Exponents &exponents);

    /// Those of all functions of a @p degree.
    static const std::vector<Barycentric<dim>> &
    points(const unsigned int degree);

    /// The functions of a @p degree at a point.
    static std::vector<double>
    functions(const unsigned int degree, const Barycentric<dim> &point);

    /// The coefficients (n x n) of a polynomial with values at the points(),
    /// and of one with the moments int f B, relative to the size of the
    /// simplex.
    static const FullMatrix<double> &
    coefficients(const unsigned int degree);
    static const FullMatrix<double> &
    coefficients_of_moments(const unsigned int degree);

    /// The integrals of the products of two functions, relative to the size of
    /// the simplex.
    static FullMatrix<double>
    mass_matrix(const unsigned int degree);
  };



  constexpr unsigned int n_quadratics = Bernstein<2>::n_functions(2),
                         n_cubics     = Bernstein<2>::n_functions(3);

  /// Of one function on a triangle at a point: by the coordinates x and y.
  struct Jet
  {
    double       value;
    Tensor<1, 2> gradient;
    Tensor<2, 2> hessian;
  };

  /// The cubic functions of Bernstein<2>.
  std::array<Jet, n_cubics>
  cubics(const std::array<Tensor<1, 2>, 3> &gradients,
         const Barycentric<2>              &point);

  /// The integrals of the quadratic functions times a linear function with
  /// these @p values at the corners, over a triangle of area 1.
  std::array<double, n_quadratics>
  quadratic_moments(const std::array<double, 3> &values);
} // namespace ElastoPlastic

#endif
