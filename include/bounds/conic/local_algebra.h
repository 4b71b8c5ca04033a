// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_local_algebra_h
#define bounds_conic_local_algebra_h

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/simd.h"
#include "bounds/conic/tolerances.h"

/// Products and factors of the small matrices of a ConicBlock. Matrices are
/// stored by rows, symmetric ones and factors by the rows of their lower half.
/// A Number is a double, or one double of each of several blocks
/// (base/simd.h). The functions of FullMatrix and of LAPACK are made for larger
/// matrices: they take three times as long for one block, and LAPACK's rounding
/// errors depend on the processor.
namespace ElastoPlastic::LocalAlgebra
{
  using namespace dealii;

  /// So many rows of a matrix are treated together: their sums do not wait for
  /// each other.
  constexpr unsigned int n_together = 4;



  /// Makes a vector of @p n zeros.
  template <typename Number>
  void
  clear(AlignedVector<Number> &vector, const unsigned int n)
  {
    vector.resize_fast(n);
    std::fill(vector.begin(), vector.end(), Number(0.));
  }



  /// y += A x for an m x n matrix A
  template <typename Number>
  void
  add_product(Number            *y,
              const Number      *a,
              const unsigned int m,
              const unsigned int n,
              const Number      *x)
  {
    unsigned int i = 0;
    for (; i + n_together <= m; i += n_together, a += n_together * n)
      {
        std::array<Number, n_together> sums;
        sums.fill(Number(0.));
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int k = 0; k < n_together; ++k)
            sums[k] += a[k * n + j] * x[j];
        for (unsigned int k = 0; k < n_together; ++k)
          y[i + k] += sums[k];
      }
    for (; i < m; ++i, a += n)
      {
        Number sum = 0.;
        for (unsigned int j = 0; j < n; ++j)
          sum += a[j] * x[j];
        y[i] += sum;
      }
  }



  inline void
  add_product(double *y, const FullMatrix<double> &a, const double *x)
  {
    if (!a.empty())
      add_product(y, &a(0, 0), a.m(), a.n(), x);
  }



  /// y += A^T x for an m x n matrix A
  template <typename Number>
  void
  add_transposed_product(Number            *y,
                         const Number      *a,
                         const unsigned int m,
                         const unsigned int n,
                         const Number      *x)
  {
    unsigned int i = 0;
    for (; i + n_together <= m; i += n_together, a += n_together * n)
      for (unsigned int j = 0; j < n; ++j)
        {
          Number sum = y[j];
          for (unsigned int k = 0; k < n_together; ++k)
            sum += a[k * n + j] * x[i + k];
          y[j] = sum;
        }
    for (; i < m; ++i, a += n)
      for (unsigned int j = 0; j < n; ++j)
        y[j] += a[j] * x[i];
  }



  inline void
  add_transposed_product(double                   *y,
                         const FullMatrix<double> &a,
                         const double             *x)
  {
    if (!a.empty())
      add_transposed_product(y, &a(0, 0), a.m(), a.n(), x);
  }



  /// The number of entries of the lower half of a matrix with @p n rows, and
  /// where its row @p n begins.
  constexpr unsigned int
  lower_size(const unsigned int n)
  {
    return n * (n + 1) / 2;
  }



  /// H += B B^T for an m x n matrix B and for as many rows and columns of the
  /// lower half H, from @p first on.
  template <typename Number>
  void
  add_square(Number            *h,
             const unsigned int first,
             const Number      *b,
             const unsigned int m,
             const unsigned int n)
  {
    for (unsigned int i = 0; i < m; i += n_together)
      for (unsigned int j = 0; j <= i; j += n_together)
        {
          // Behind the last row comes the last one again.
          std::array<const Number *, n_together> rows, columns;
          for (unsigned int k = 0; k < n_together; ++k)
            {
              rows[k]    = b + std::min(i + k, m - 1) * n;
              columns[k] = b + std::min(j + k, m - 1) * n;
            }
          Number sums[n_together][n_together];
          for (auto &row : sums)
            for (Number &sum : row)
              sum = 0.;
          for (unsigned int l = 0; l < n; ++l)
            for (unsigned int k = 0; k < n_together; ++k)
              for (unsigned int c = 0; c < n_together; ++c)
                sums[k][c] += rows[k][l] * columns[c][l];
          for (unsigned int k = 0; k < n_together && i + k < m; ++k)
            {
              Number *const row = h + lower_size(first + i + k) + first + j;
              for (unsigned int c = 0; c < n_together && j + c <= i + k; ++c)
                row[c] += sums[k][c];
            }
        }
  }



  /// H := L with H = L L^T, but the inverse of each diagonal entry.
  /// @return false if H is not positive definite.
  template <typename Number>
  bool
  factorize(Number *h, const unsigned int n)
  {
    for (unsigned int j = 0; j < n; ++j)
      {
        Number &pivot = h[lower_size(j) + j];
        for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
          if (!(lane_of(pivot, lane) > 0))
            return false;
        pivot = 1. / std::sqrt(pivot);
        for (unsigned int i = j + 1; i < n; ++i)
          {
            Number *const row = h + lower_size(i);
            row[j] *= pivot;
            const Number factor = row[j];
            for (unsigned int l = j + 1; l <= i; ++l)
              row[l] -= factor * h[lower_size(l) + j];
          }
      }
    return true;
  }



  /// x := L^-1 x for each of @p n_vectors vectors, which begin @p stride
  /// numbers apart.
  template <unsigned int n_vectors, typename Number>
  void
  solve_lower(const Number      *factor,
              const unsigned int n,
              Number            *x,
              const unsigned int stride)
  {
    for (unsigned int j = 0; j < n; ++j)
      {
        const Number *const           row = factor + lower_size(j);
        std::array<Number, n_vectors> sums;
        for (unsigned int k = 0; k < n_vectors; ++k)
          sums[k] = x[k * stride + j];
        for (unsigned int l = 0; l < j; ++l)
          for (unsigned int k = 0; k < n_vectors; ++k)
            sums[k] -= row[l] * x[k * stride + l];
        for (unsigned int k = 0; k < n_vectors; ++k)
          x[k * stride + j] = sums[k] * row[j];
      }
  }



  /// B := B L^-T for an m x n matrix B, whose rows begin @p stride numbers
  /// apart
  template <typename Number>
  void
  solve_rows(const Number      *factor,
             const unsigned int n,
             Number            *b,
             const unsigned int m,
             const unsigned int stride)
  {
    unsigned int i = 0;
    for (; i + n_together <= m; i += n_together)
      solve_lower<n_together>(factor, n, b + i * stride, stride);
    for (; i < m; ++i)
      solve_lower<1>(factor, n, b + i * stride, stride);
  }



  /// x := H^-1 x
  template <typename Number>
  void
  solve(const Number *factor, const unsigned int n, Number *x)
  {
    for (unsigned int j = 0; j < n; ++j)
      {
        x[j] *= factor[lower_size(j) + j];
        for (unsigned int i = j + 1; i < n; ++i)
          x[i] -= factor[lower_size(i) + j] * x[j];
      }
    for (unsigned int i = n; i-- > 0;)
      {
        const Number *const row = factor + lower_size(i);
        x[i] *= row[i];
        for (unsigned int j = 0; j < i; ++j)
          x[j] -= row[j] * x[i];
      }
  }



  /// Gram and Schmidt's method, twice because of rounding errors.
  inline void
  orthonormalize_rows(FullMatrix<double> &a)
  {
    const auto product = [&](const unsigned int i, const unsigned int j) {
      double sum = 0;
      for (unsigned int k = 0; k < a.n(); ++k)
        sum += a(i, k) * a(j, k);
      return sum;
    };
    for (unsigned int i = 0; i < a.m(); ++i)
      {
        for (unsigned int repetition = 0; repetition < 2; ++repetition)
          for (unsigned int j = 0; j < i; ++j)
            a.add_row(i, -product(i, j), j);
        const double norm = std::sqrt(product(i, i));
        for (unsigned int k = 0; k < a.n(); ++k)
          a(i, k) /= norm;
      }
  }



  /// An orthonormal basis of the vectors x with A x = 0, one per row. The
  /// diagonal of A^T A gives the pivots of an elimination, the largest first;
  /// it ends where only rounding errors are left, and what it has not
  /// eliminated is free.
  inline FullMatrix<double>
  kernel(const FullMatrix<double> &a)
  {
    const unsigned int n = a.n();
    FullMatrix<double> square(n, n);
    for (unsigned int k = 0; k < a.m(); ++k)
      for (unsigned int i = 0; i < n; ++i)
        if (a(k, i) != 0)
          for (unsigned int j = 0; j < n; ++j)
            square(i, j) += a(k, i) * a(k, j);

    std::vector<unsigned int> order(n); // with the pivots first
    std::iota(order.begin(), order.end(), 0);
    double       largest = 0;
    unsigned int rank    = 0;
    for (; rank < n; ++rank)
      {
        std::iter_swap(order.begin() + rank,
                       std::max_element(order.begin() + rank,
                                        order.end(),
                                        [&](const auto i, const auto j) {
                                          return square(i, i) < square(j, j);
                                        }));
        const unsigned int p     = order[rank];
        const double       pivot = square(p, p);
        largest                  = std::max(largest, pivot);
        if (!(pivot > Tolerance::pivot * largest))
          break;
        for (unsigned int j = 0; j < n; ++j)
          square(p, j) /= pivot;
        for (unsigned int i = 0; i < n; ++i)
          if (const double factor = square(i, p); i != p && factor != 0)
            for (unsigned int j = 0; j < n; ++j)
              square(i, j) -= factor * square(p, j);
      }

    FullMatrix<double> basis(n - rank, n);
    for (unsigned int k = 0; k < basis.m(); ++k)
      {
        const unsigned int free = order[rank + k];
        basis(k, free)          = 1.;
        for (unsigned int i = 0; i < rank; ++i)
          basis(k, order[i]) = -square(order[i], free);
      }
    orthonormalize_rows(basis);
    return basis;
  }
} // namespace ElastoPlastic::LocalAlgebra

#endif
