// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/math/special_functions/binomial.hpp>

#include <algorithm>
#include <numeric>

#include "bounds/stress/bernstein.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr unsigned int max_degree = 4;

    template <typename Value>
    using ByDegrees = std::array<Value, max_degree + 1>;

    /// make(n) for all degrees n from @p first on.
    template <typename Make>
    auto
    by_degrees(const unsigned int first, const Make &make)
    {
      ByDegrees<decltype(make(0))> result;
      for (unsigned int n = first; n <= max_degree; ++n)
        result[n] = make(n);
      return result;
    }



    template <int dim>
    std::vector<typename Bernstein<dim>::Exponents>
    make_exponents(const int degree)
    {
      std::vector<typename Bernstein<dim>::Exponents> result;
      const auto                                      add = [&](
                         const typename Bernstein<dim>::Exponents &exponents) {
        if (std::find(result.begin(), result.end(), exponents) == result.end())
          result.push_back(exponents);
      };
      const auto between =
        [degree](const unsigned int a, const unsigned int b, const int i) {
          typename Bernstein<dim>::Exponents exponents = {};
          exponents[a] += degree - i;
          exponents[b] += i;
          return exponents;
        };
      for (unsigned int i = 0; dim > 1 && i <= dim; ++i)
        add(between(i, i, 0));
      for (unsigned int e = 0; e < edges_per_simplex<dim>; ++e)
        for (int i = 0; i <= degree; ++i)
          add(between(ends_of_edge<dim>(e)[0], ends_of_edge<dim>(e)[1], i));
      // (the others: all exponents but the last may be anything up to degree)
      for (typename Bernstein<dim>::Exponents all = {}; all[dim] == 0;)
        {
          typename Bernstein<dim>::Exponents exponents = all;
          exponents[dim] = degree - std::accumulate(all.begin(), all.end(), 0);
          if (exponents[dim] >= 0)
            add(exponents);
          unsigned int i = 0;
          while (i < dim && all[i] == degree)
            all[i++] = 0;
          ++all[i];
        }
      return result;
    }



    FullMatrix<double>
    inverse(FullMatrix<double> matrix)
    {
      matrix.gauss_jordan();
      return matrix;
    }



    template <int dim>
    FullMatrix<double>
    values_at_points(const unsigned int degree)
    {
      const unsigned int n = Bernstein<dim>::n_functions(degree);
      FullMatrix<double> values(n, n);
      for (unsigned int p = 0; p < n; ++p)
        {
          const auto at_point =
            Bernstein<dim>::functions(degree,
                                      Bernstein<dim>::points(degree)[p]);
          std::copy(at_point.begin(), at_point.end(), &values(p, 0));
        }
      return values;
    }
  } // namespace



  template <int dim>
  const std::vector<typename Bernstein<dim>::Exponents> &
  Bernstein<dim>::exponents(const unsigned int degree)
  {
    static const auto all = by_degrees(0, make_exponents<dim>);
    AssertIndexRange(degree, all.size());
    return all[degree];
  }



  template <int dim>
  unsigned int
  Bernstein<dim>::number_of(const Exponents &of_function)
  {
    const auto place = [](const Exponents &exponents) {
      unsigned int result = 0;
      for (const int exponent : exponents)
        result = (max_degree + 1) * result + exponent;
      return result;
    };
    static const auto numbers = [place]() {
      std::vector<unsigned int> result;
      for (unsigned int n = 0; n <= max_degree; ++n)
        for (unsigned int i = 0; i < n_functions(n); ++i)
          {
            const unsigned int p = place(exponents(n)[i]);
            result.resize(std::max<std::size_t>(result.size(), p + 1));
            result[p] = i;
          }
      return result;
    }();
    AssertIndexRange(place(of_function), numbers.size());
    return numbers[place(of_function)];
  }



  template <int dim>
  Barycentric<dim>
  Bernstein<dim>::point_of(const Exponents &exponents)
  {
    const double degree =
      std::accumulate(exponents.begin(), exponents.end(), 0);
    Barycentric<dim> point;
    for (unsigned int i = 0; i <= dim; ++i)
      point[i] = exponents[i] / degree;
    return point;
  }



  template <int dim>
  const std::vector<Barycentric<dim>> &
  Bernstein<dim>::points(const unsigned int degree)
  {
    static const auto all = by_degrees(1, [](const unsigned int n) {
      std::vector<Barycentric<dim>> result;
      for (const auto &of_function : exponents(n))
        result.push_back(point_of(of_function));
      return result;
    });
    AssertIndexRange(degree, all.size());
    return all[degree];
  }



  template <int dim>
  std::vector<double>
  Bernstein<dim>::functions(const unsigned int      degree,
                            const Barycentric<dim> &point)
  {
    constexpr ByDegrees<double>            factorials = {{1., 1., 2., 6., 24.}};
    std::array<ByDegrees<double>, dim + 1> powers; // over their factorials
    for (unsigned int i = 0; i <= dim; ++i)
      {
        double power = 1.;
        for (unsigned int p = 0; p <= max_degree; ++p)
          {
            powers[i][p] = power / factorials[p];
            power *= point[i];
          }
      }
    const auto         &all = exponents(degree);
    std::vector<double> values(all.size(), factorials[degree]);
    for (unsigned int k = 0; k < all.size(); ++k)
      for (unsigned int i = 0; i <= dim; ++i)
        values[k] *= powers[i][all[k][i]];
    return values;
  }



  template <int dim>
  const FullMatrix<double> &
  Bernstein<dim>::coefficients(const unsigned int degree)
  {
    static const auto all = by_degrees(1, [](const unsigned int n) {
      return inverse(values_at_points<dim>(n));
    });
    AssertIndexRange(degree, all.size());
    return all[degree];
  }



  template <int dim>
  const FullMatrix<double> &
  Bernstein<dim>::coefficients_of_moments(const unsigned int degree)
  {
    static const auto all = by_degrees(1, [](const unsigned int n) {
      return inverse(mass_matrix(n));
    });
    AssertIndexRange(degree, all.size());
    return all[degree];
  }



  // The product of two functions is a function of twice the degree n times the
  // product of all binom(i + j, i), i and j being their exponents, over
  // binom(2n, n). All functions of a degree have the same integral.
  template <int dim>
  FullMatrix<double>
  Bernstein<dim>::mass_matrix(const unsigned int degree)
  {
    using boost::math::binomial_coefficient;
    const auto        &all = exponents(degree);
    FullMatrix<double> mass(all.size(), all.size());
    for (unsigned int a = 0; a < all.size(); ++a)
      for (unsigned int b = 0; b < all.size(); ++b)
        {
          mass(a, b) = 1. / binomial_coefficient<double>(2 * degree, degree) /
                       n_functions(2 * degree);
          for (unsigned int i = 0; i <= dim; ++i)
            mass(a, b) *=
              binomial_coefficient<double>(all[a][i] + all[b][i], all[a][i]);
        }
    return mass;
  }



  // Times the barycentric coordinate i, the function with the exponents a is
  // (a_i + 1) / (n + 1) times one of the next degree.
  template <int dim>
  std::vector<double>
  Bernstein<dim>::moments(const unsigned int                 degree,
                          const std::array<double, dim + 1> &values)
  {
    std::vector<double> result;
    for (const Exponents &of_function : exponents(degree))
      {
        double sum = 0;
        for (unsigned int i = 0; i <= dim; ++i)
          sum += (of_function[i] + 1) * values[i];
        result.push_back(sum / ((degree + 1) * n_functions(degree + 1)));
      }
    return result;
  }



  template struct Bernstein<1>;
  template struct Bernstein<2>;
  template struct Bernstein<3>;
} // namespace ElastoPlastic
