// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_local_algebra_h
#define equilibrium_local_algebra_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/lapack_templates.h>

#include <algorithm>

/// Products and factors of the small matrices of a ConicBlock. The functions of
/// FullMatrix are made for larger ones: they take three times as long.
namespace ElastoPlastic::LocalAlgebra
{
  using namespace dealii;

  /// Consecutive numbers.
  struct Part
  {
    std::size_t begin;
    std::size_t end;
  };



  /// y += factor A^T x for a part of the rows and columns of A: x and y begin
  /// with these.
  inline void
  add_transposed_product(double                   *y,
                         const FullMatrix<double> &a,
                         const Part               &rows,
                         const Part               &columns,
                         const double             *x,
                         const double              factor)
  {
    const unsigned int n = columns.end - columns.begin;
    for (unsigned int i = rows.begin; i < rows.end; ++i)
      {
        const double *const row  = &a(i, columns.begin);
        const double        part = factor * x[i - rows.begin];
        for (unsigned int j = 0; j < n; ++j)
          y[j] += row[j] * part;
      }
  }



  /// y += factor A^T x
  inline void
  add_transposed_product(double                   *y,
                         const FullMatrix<double> &a,
                         const double             *x,
                         const double              factor = 1.)
  {
    add_transposed_product(y, a, {0, a.m()}, {0, a.n()}, x, factor);
  }



  /// y += factor A x for a part of the rows and columns of A: x and y begin
  /// with these.
  inline void
  add_product(double                   *y,
              const FullMatrix<double> &a,
              const Part               &rows,
              const Part               &columns,
              const double             *x,
              const double              factor)
  {
    const unsigned int m = rows.end - rows.begin, stride = a.n(),
                       n = columns.end - columns.begin;
    if (m == 0 || n == 0)
      return;
    const double *row = &a(rows.begin, columns.begin);
    unsigned int  i   = 0;
    for (; i + 4 <= m; i += 4, row += 4 * stride)
      { // four sums that do not wait for each other
        double sum[4] = {};
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int k = 0; k < 4; ++k)
            sum[k] += row[k * stride + j] * x[j];
        for (unsigned int k = 0; k < 4; ++k)
          y[i + k] += factor * sum[k];
      }
    for (; i < m; ++i, row += stride)
      {
        double sum = 0;
        for (unsigned int j = 0; j < n; ++j)
          sum += row[j] * x[j];
        y[i] += factor * sum;
      }
  }



  /// y += factor A x
  inline void
  add_product(double                   *y,
              const FullMatrix<double> &a,
              const double             *x,
              const double              factor = 1.)
  {
    add_product(y, a, {0, a.m()}, {0, a.n()}, x, factor);
  }



  /// H := L with H = L L^T, for unknowns that H does not couple to others; the
  /// upper half is not used. @return false if H is not positive definite.
  inline bool
  factorize(FullMatrix<double> &h, const Part &part)
  {
    const types::blas_int n = h.m(), size = part.end - part.begin;
    types::blas_int       info = 0;
    potrf("U", &size, &h(part.begin, part.begin), &n, &info); // it sees L^T
    return info == 0;
  }



  /// x := L^-1 x for a part of the unknowns, for @p n_vectors one after the
  /// other.
  inline void
  solve_lower(const FullMatrix<double> &factor,
              const Part               &part,
              double                   *x,
              const types::blas_int     n_vectors = 1)
  {
    const types::blas_int n = factor.m(), size = part.end - part.begin;
    types::blas_int       info = 0;
    trtrs("U",
          "T",
          "N",
          &size,
          &n_vectors,
          &factor(part.begin, part.begin),
          &n,
          x + part.begin,
          &n,
          &info);
  }



  /// x := L^-T x for a part of the unknowns.
  inline void
  solve_upper(const FullMatrix<double> &factor, const Part &part, double *x)
  {
    const types::blas_int n = factor.m(), size = part.end - part.begin, one = 1;
    types::blas_int       info = 0;
    trtrs("U",
          "N",
          "N",
          &size,
          &one,
          &factor(part.begin, part.begin),
          &n,
          x + part.begin,
          &n,
          &info);
  }



  /// An orthonormal basis of the vectors x with A x = 0, one per row: of the
  /// singular vectors of A^T A, those whose singular values are rounding
  /// errors.
  inline FullMatrix<double>
  kernel(const FullMatrix<double> &a)
  {
    const unsigned int n = a.n();
    FullMatrix<double> square(n, n);
    a.Tmmult(square, a);
    LAPACKFullMatrix<double> decomposition(n, n);
    decomposition = square;
    decomposition.compute_svd();
    unsigned int rank = 0;
    while (rank < n && decomposition.singular_value(rank) >
                         1e-12 * decomposition.singular_value(0))
      ++rank;
    FullMatrix<double> basis(n - rank, n);
    for (unsigned int i = rank; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        basis(i - rank, j) = decomposition.get_svd_vt()(i, j);
    return basis;
  }
} // namespace ElastoPlastic::LocalAlgebra

#endif
