// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/math/special_functions/binomial.hpp>

#include <algorithm>
#include <cmath>

#include "bounds/stress/bernstein.h"

namespace ElastoPlastic::Bernstein
{
  namespace
  {
    constexpr unsigned int max_side_degree = 4;

    constexpr std::array<Exponents, n_cubics> cubic_exponents = {{{{3, 0, 0}},
                                                                  {{0, 3, 0}},
                                                                  {{0, 0, 3}},
                                                                  {{2, 1, 0}},
                                                                  {{1, 2, 0}},
                                                                  {{0, 2, 1}},
                                                                  {{0, 1, 2}},
                                                                  {{1, 0, 2}},
                                                                  {{2, 0, 1}},
                                                                  {{1, 1, 1}}}};

    constexpr std::array<Exponents, n_quadratics> quadratic_exponents = {
      {{{2, 0, 0}},
       {{0, 2, 0}},
       {{0, 0, 2}},
       {{1, 1, 0}},
       {{0, 1, 1}},
       {{1, 0, 1}}}};



    /// The powers 0 to 3 of the barycentric coordinates of a point, over their
    /// factorials.
    class Powers
    {
    public:
      explicit Powers(const Barycentric &point)
      {
        for (unsigned int i = 0; i < 3; ++i)
          values[i] = {{1.,
                        point[i],
                        point[i] * point[i] / 2.,
                        point[i] * point[i] * point[i] / 6.}};
      }

      /// The multinomial function of these exponents; zero if one of them is
      /// negative, as derivatives have it.
      double
      function(const Exponents &exponents) const
      {
        constexpr std::array<double, 4> factorials = {{1., 1., 2., 6.}};
        const auto [i, j, k]                       = exponents;
        return i < 0 || j < 0 || k < 0 ? 0. :
                                         factorials[i + j + k] * values[0][i] *
                                           values[1][j] * values[2][k];
      }

    private:
      std::array<std::array<double, 4>, 3> values;
    };



    Exponents
    lowered(Exponents exponents, const unsigned int i)
    {
      --exponents[i];
      return exponents;
    }



    template <std::size_t n>
    std::array<Barycentric, n>
    points_of(const std::array<Exponents, n> &exponents, const double degree)
    {
      std::array<Barycentric, n> points;
      for (unsigned int p = 0; p < n; ++p)
        for (unsigned int i = 0; i < 3; ++i)
          points[p][i] = exponents[p][i] / degree;
      return points;
    }



    template <std::size_t n>
    FullMatrix<double>
    inverse_of_values(const std::array<Exponents, n>   &exponents,
                      const std::array<Barycentric, n> &points)
    {
      FullMatrix<double> values(n, n);
      for (unsigned int p = 0; p < n; ++p)
        for (unsigned int i = 0; i < n; ++i)
          values(p, i) = Powers(points[p]).function(exponents[i]);
      values.gauss_jordan();
      return values;
    }



    // int B_i B_j dt = binom(n, i) binom(n, j) / (binom(2n, i + j) (2n + 1))
    FullMatrix<double>
    inverse_of_side_products(const unsigned int degree)
    {
      using boost::math::binomial_coefficient;
      FullMatrix<double> products(degree + 1, degree + 1);
      for (unsigned int i = 0; i <= degree; ++i)
        for (unsigned int j = 0; j <= degree; ++j)
          products(i, j) = binomial_coefficient<double>(degree, i) *
                           binomial_coefficient<double>(degree, j) /
                           binomial_coefficient<double>(2 * degree, i + j) /
                           (2. * degree + 1.);
      products.gauss_jordan();
      return products;
    }



    FullMatrix<double>
    inverse_of_side_values(const unsigned int degree)
    {
      FullMatrix<double> values(degree + 1, degree + 1);
      for (unsigned int p = 0; p <= degree; ++p)
        {
          const auto functions =
            side_functions(degree, p / static_cast<double>(degree));
          for (unsigned int i = 0; i <= degree; ++i)
            values(p, i) = functions[i];
        }
      values.gauss_jordan();
      return values;
    }
  } // namespace



  const std::vector<Exponents> &
  exponents(const unsigned int degree)
  {
    static const std::array<std::vector<Exponents>, 3> by_degrees = {
      {{{{0, 0, 0}}},
       {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}},
       {quadratic_exponents.begin(), quadratic_exponents.end()}}};
    AssertIndexRange(degree, by_degrees.size());
    return by_degrees[degree];
  }



  unsigned int
  number_of(const Exponents &of_function)
  {
    const auto &all =
      exponents(of_function[0] + of_function[1] + of_function[2]);
    return std::find(all.begin(), all.end(), of_function) - all.begin();
  }



  Barycentric
  point_of(const Exponents &exponents)
  {
    const double degree = exponents[0] + exponents[1] + exponents[2];
    return {
      {exponents[0] / degree, exponents[1] / degree, exponents[2] / degree}};
  }



  std::vector<double>
  functions(const unsigned int degree, const Barycentric &point)
  {
    const Powers        powers(point);
    std::vector<double> values;
    for (const Exponents &of_function : exponents(degree))
      values.push_back(powers.function(of_function));
    return values;
  }



  // The derivative of a function of degree n by a barycentric coordinate is n
  // times one of degree n - 1.
  std::array<Jet, n_cubics>
  cubics(const std::array<Tensor<1, 2>, 3> &gradients, const Barycentric &point)
  {
    const Powers              powers(point);
    std::array<Jet, n_cubics> jets;
    for (unsigned int f = 0; f < n_cubics; ++f)
      {
        const Exponents &exponents = cubic_exponents[f];
        jets[f].value              = powers.function(exponents);
        for (unsigned int i = 0; i < 3; ++i)
          {
            const Exponents once = lowered(exponents, i);
            if (once[i] < 0)
              continue;
            jets[f].gradient += 3. * powers.function(once) * gradients[i];
            for (unsigned int j = 0; j < 3; ++j)
              jets[f].hessian += 6. * powers.function(lowered(once, j)) *
                                 outer_product(gradients[i], gradients[j]);
          }
      }
    return jets;
  }



  const std::array<Barycentric, n_cubics> &
  cubic_points()
  {
    static const auto points = points_of(cubic_exponents, 3.);
    return points;
  }



  const std::array<Barycentric, n_quadratics> &
  quadratic_points()
  {
    static const auto points = points_of(quadratic_exponents, 2.);
    return points;
  }



  std::array<double, n_quadratics>
  quadratic_moments(const std::array<double, 3> &values)
  {
    std::array<double, n_quadratics> result;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const double here = values[i], next = values[(i + 1) % 3],
                     last = values[(i + 2) % 3];
        result[i]         = here / 10. + (next + last) / 30.;
        result[3 + i]     = (here + next) / 15. + last / 30.;
      }
    return result;
  }



  const FullMatrix<double> &
  cubic_coefficients()
  {
    static const auto matrix =
      inverse_of_values(cubic_exponents, cubic_points());
    return matrix;
  }



  const FullMatrix<double> &
  quadratic_coefficients()
  {
    static const auto matrix =
      inverse_of_values(quadratic_exponents, quadratic_points());
    return matrix;
  }



  const FullMatrix<double> &
  side_coefficients(const unsigned int degree)
  {
    static const auto matrices = []() {
      std::array<FullMatrix<double>, max_side_degree + 1> result;
      for (unsigned int n = 1; n <= max_side_degree; ++n)
        result[n] = inverse_of_side_values(n);
      return result;
    }();
    AssertIndexRange(degree, matrices.size());
    return matrices[degree];
  }



  std::vector<double>
  side_functions(const unsigned int degree, const double t)
  {
    std::vector<double> values;
    for (unsigned int i = 0; i <= degree; ++i)
      values.push_back(boost::math::binomial_coefficient<double>(degree, i) *
                       std::pow(t, static_cast<int>(i)) *
                       std::pow(1. - t, static_cast<int>(degree - i)));
    return values;
  }



  const FullMatrix<double> &
  side_coefficients_of_moments(const unsigned int degree)
  {
    static const std::array<FullMatrix<double>, 2> matrices = {
      {inverse_of_side_products(1), inverse_of_side_products(2)}};
    AssertIndexRange(degree - 1, matrices.size());
    return matrices[degree - 1];
  }
} // namespace ElastoPlastic::Bernstein
