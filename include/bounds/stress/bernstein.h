// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_bernstein_h
#define bounds_stress_bernstein_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <numeric>
#include <type_traits>
#include <vector>

#include "bounds/mesh/simplex.h"

namespace ElastoPlastic
{
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

    /// The number of a function among those of its degree (at most 4).
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

    /// The integrals of all functions of a @p degree times the linear function
    /// with these @p values at the corners, relative to the size of the
    /// simplex.
    static std::vector<double>
    moments(const unsigned int                 degree,
            const std::array<double, dim + 1> &values);

    /// The coefficients of the polynomial of a @p degree that is
    /// function(point) at the points().
    template <typename Function>
    static auto
    interpolate(const unsigned int degree, const Function &function)
    {
      const auto &all = points(degree);
      std::vector<std::decay_t<decltype(function(all[0]))>> result(all.size());
      for (unsigned int p = 0; p < all.size(); ++p)
        {
          const auto at_point = function(all[p]);
          for (unsigned int i = 0; i < all.size(); ++i)
            result[i] += coefficients(degree)(i, p) * at_point;
        }
      return result;
    }

    /// What a polynomial with the coefficients from @p begin on is at a point.
    template <typename Iterator>
    static auto
    value(const unsigned int      degree,
          const Iterator         &begin,
          const Barycentric<dim> &point)
    {
      const auto weights = functions(degree, point);
      return std::inner_product(weights.begin(),
                                weights.end(),
                                begin,
                                std::decay_t<decltype(*begin)>());
    }

    /// Its derivatives by the barycentric coordinates. That of sum_a c_a B_a by
    /// coordinate i is n sum_b c_{b + e_i} B_b over the functions of degree
    /// n - 1.
    template <typename Iterator>
    static auto
    derivatives(const unsigned int      degree,
                const Iterator         &begin,
                const Barycentric<dim> &point)
    {
      std::array<std::decay_t<decltype(*begin)>, dim + 1> result = {};
      const auto &lower   = exponents(degree - 1);
      const auto  weights = functions(degree - 1, point);
      for (unsigned int i = 0; i <= dim; ++i)
        for (unsigned int b = 0; b < lower.size(); ++b)
          result[i] +=
            1. * degree * weights[b] * begin[number_of(raised(lower[b], i))];
      return result;
    }

    /// The symmetric gradient of one whose values are vectors, on a simplex
    /// with these @p corners.
    template <typename Iterator>
    static SymmetricTensor<2, dim>
    symmetric_gradient(const Corners<dim>     &corners,
                       const unsigned int      degree,
                       const Iterator         &begin,
                       const Barycentric<dim> &point)
    {
      const auto     changes = derivatives(degree, begin, point);
      const auto     by      = gradients(corners);
      Tensor<2, dim> sum;
      for (unsigned int i = 0; i <= dim; ++i)
        sum += outer_product(changes[i], by[i]);
      return symmetrize(sum);
    }

    /// The exponents of a function times a barycentric coordinate.
    static Exponents
    raised(Exponents exponents, const unsigned int i)
    {
      ++exponents[i];
      return exponents;
    }
  };
} // namespace ElastoPlastic

#endif
