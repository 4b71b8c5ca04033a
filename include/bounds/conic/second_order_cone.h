// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_second_order_cone_h
#define bounds_conic_second_order_cone_h

#include <deal.II/base/array_view.h>

#include <array>
#include <cmath>

#include "base/simd.h"

/// Algebra of the second-order cones { (v_0, v_1) : |v_1| <= v_0 }, of
/// dimension 1 (numbers that are not negative) to 6, as an interior point
/// method needs it @cite vandenberghe_2010. Vectors are views of as many
/// numbers as the cone has dimensions.
namespace ElastoPlastic::SecondOrderCone
{
  using namespace dealii;

  constexpr unsigned int max_size = 6;

  using View      = ArrayView<double>;
  using ConstView = ArrayView<const double>;



  /// v_1 . w_1, without the first entry.
  inline double
  product_of_tails(const ConstView v, const ConstView w)
  {
    double sum = 0;
    for (unsigned int i = 1; i < v.size(); ++i)
      sum += v[i] * w[i];
    return sum;
  }



  inline double
  norm_of_tail(const ConstView v)
  {
    return std::sqrt(product_of_tails(v, v));
  }



  /// v_0^2 - |v_1|^2: positive inside the cone, zero on its boundary.
  inline double
  determinant(const ConstView v)
  {
    const double tail = norm_of_tail(v);
    return (v[0] - tail) * (v[0] + tail);
  }



  /// The Jordan product (v . w, v_0 w_1 + w_0 v_1).
  inline void
  multiply(const View result, const ConstView v, const ConstView w)
  {
    const double first = v[0] * w[0] + product_of_tails(v, w);
    for (unsigned int i = 1; i < v.size(); ++i)
      result[i] = v[0] * w[i] + w[0] * v[i];
    result[0] = first;
  }



  /// The x whose Jordan product with v is d. It may be d itself.
  inline void
  divide(const View x, const ConstView d, const ConstView v)
  {
    const double first =
      (v[0] * d[0] - product_of_tails(v, d)) / determinant(v);
    for (unsigned int i = 1; i < v.size(); ++i)
      x[i] = (d[i] - first * v[i]) / v[0];
    x[0] = first;
  }



  /// The largest step a for which v + a d is in the cone, inverted: 0 if there
  /// is no limit. v must be inside.
  inline double
  inverse_step(const ConstView v, const ConstView d)
  {
    // A hyperbolic rotation carries v to a multiple of (1, 0).
    const double root  = std::sqrt(determinant(v));
    const double first = (v[0] * d[0] - product_of_tails(v, d)) / root;
    const double share = (d[0] + first) / (v[0] + root);
    double       tail  = 0;
    for (unsigned int i = 1; i < v.size(); ++i)
      tail += std::pow(d[i] - share * v[i], 2);
    return std::max(0., (std::sqrt(tail) - first) / root);
  }



  /// The symmetric scaling W of Nesterov and Todd for two vectors s and z
  /// inside the cone: W z = W^-1 s. A @p Number is a double, or one of each of
  /// several cones of the same size.
  template <typename Number>
  class Scaling
  {
  public:
    using Vectors = ArrayView<Number>;

    /// Of several cones of this size, to be filled by set_lane().
    explicit Scaling(const unsigned int size)
      : size(size)
    {}

    Scaling(const ConstView s, const ConstView z)
      : size(s.size())
    {
      const double of_s  = std::sqrt(determinant(s));
      const double of_z  = std::sqrt(determinant(z));
      const double gamma = std::sqrt(
        0.5 + 0.5 * (s[0] * z[0] + product_of_tails(s, z)) / (of_s * of_z));
      factor       = std::sqrt(of_s / of_z);
      direction[0] = 0.5 / gamma * (s[0] / of_s + z[0] / of_z);
      for (unsigned int i = 1; i < size; ++i)
        direction[i] = 0.5 / gamma * (s[i] / of_s - z[i] / of_z);
    }

    void
    set_lane(const unsigned int lane, const Scaling<double> &scaling)
    {
      lane_of(factor, lane) = scaling.factor;
      for (unsigned int i = 0; i < size; ++i)
        lane_of(direction[i], lane) = scaling.direction[i];
    }

    /// v := W v
    void
    multiply(const Vectors &v) const
    {
      apply(v, factor, 1.);
    }

    /// v := W^-1 v
    void
    divide(const Vectors &v) const
    {
      apply(v, 1. / factor, -1.);
    }

    /// Multiplies @p n vectors, one after the other, by a B with B^T B = W^-2.
    /// From @p first_row on, they are all rows of vectors whose entry before,
    /// if there is one, is zero: B need not be W^-1 then.
    void
    divide_columns(Number            *v,
                   const unsigned int n,
                   const unsigned int first_row) const
    {
      if (first_row == 0)
        for (unsigned int k = 0; k < n; ++k, v += size)
          divide({v, size});
      else
        divide_tails(v, n);
    }

    /// The eigenvalue of W^-2 in the directions that are orthogonal to those
    /// of s and z.
    Number
    inverse_square_across() const
    {
      return 1. / (factor * factor);
    }

  private:
    template <typename OtherNumber>
    friend class Scaling;

    // W = factor [ w_0, w_1^T; w_1, I + w_1 w_1^T / (1 + w_0) ], w being
    // the direction, with the determinant 1; its inverse has -w_1.
    void
    apply(const Vectors &v, const Number &scale, const double sign) const
    {
      Number tail = 0.;
      for (unsigned int i = 1; i < size; ++i)
        tail += direction[i] * v[i];
      tail *= sign;
      const Number first = v[0];
      const Number share = sign * (first + tail / (1. + direction[0]));
      v[0]               = scale * (direction[0] * first + tail);
      for (unsigned int i = 1; i < size; ++i)
        v[i] = scale * (v[i] + share * direction[i]);
    }

    // Without the first row and column, W^-2 is (I + 2 w_1 w_1^T) / factor^2, a
    // sum without differences. Its root is (I + c w_1 w_1^T) / factor.
    void
    divide_tails(Number *v, const unsigned int n) const
    {
      const unsigned int           n_rows = size - 1;
      std::array<Number, max_size> tail, shares;
      Number                       square = 0.;
      for (unsigned int i = 0; i < n_rows; ++i)
        square += direction[i + 1] * direction[i + 1];
      const Number inverse = 1. / factor;
      const Number share   = 2. / (1. + std::sqrt(1. + 2. * square));
      for (unsigned int i = 0; i < n_rows; ++i)
        {
          tail[i]   = inverse * direction[i + 1];
          shares[i] = share * direction[i + 1];
        }
      for (unsigned int k = 0; k < n; ++k, v += n_rows)
        {
          Number product = 0.;
          for (unsigned int i = 0; i < n_rows; ++i)
            product += tail[i] * v[i];
          for (unsigned int i = 0; i < n_rows; ++i)
            v[i] = inverse * v[i] + product * shares[i];
        }
    }

    unsigned int                 size;
    Number                       factor;
    std::array<Number, max_size> direction;
  };
} // namespace ElastoPlastic::SecondOrderCone

#endif
