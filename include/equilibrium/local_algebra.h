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

  /// y += factor A^T x
  inline void
  add_transposed_product(double                   *y,
                         const FullMatrix<double> &a,
                         const double             *x,
                         const double              factor = 1.)
  {
    const unsigned int m = a.m(), n = a.n();
    for (unsigned int i = 0; i < m; ++i)
      {
        const double *const row  = &a(i, 0);
        const double        part = factor * x[i];
        for (unsigned int j = 0; j < n; ++j)
          y[j] += row[j] * part;
      }
  }



  /// y += factor A x
  inline void
  add_product(double                   *y,
              const FullMatrix<double> &a,
              const double             *x,
              const double              factor = 1.)
  {
    const unsigned int m = a.m(), n = a.n();
    unsigned int       i = 0;
    for (; i + 4 <= m; i += 4) // four sums that do not wait for each other
      {
        const double *const row    = &a(i, 0);
        double              sum[4] = {};
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int k = 0; k < 4; ++k)
            sum[k] += row[k * n + j] * x[j];
        for (unsigned int k = 0; k < 4; ++k)
          y[i + k] += factor * sum[k];
      }
    for (; i < m; ++i)
      {
        double sum = 0;
        for (unsigned int j = 0; j < n; ++j)
          sum += a(i, j) * x[j];
        y[i] += factor * sum;
      }
  }



  /// H := L with H = L L^T; the upper half is not used. @return false if H is
  /// not positive definite.
  inline bool
  factorize(FullMatrix<double> &h)
  {
    const types::blas_int n    = h.m();
    types::blas_int       info = 0;
    potrf("U", &n, &h(0, 0), &n, &info); // LAPACK sees L^T
    return info == 0;
  }



  /// x := L^-1 x, for @p n_vectors one after the other.
  inline void
  solve_lower(const FullMatrix<double> &factor,
              double                   *x,
              const types::blas_int     n_vectors = 1)
  {
    const types::blas_int n    = factor.m();
    types::blas_int       info = 0;
    trtrs("U", "T", "N", &n, &n_vectors, &factor(0, 0), &n, x, &n, &info);
  }



  /// x := L^-T x
  inline void
  solve_upper(const FullMatrix<double> &factor, double *x)
  {
    const types::blas_int n = factor.m(), one = 1;
    types::blas_int       info = 0;
    trtrs("U", "N", "N", &n, &one, &factor(0, 0), &n, x, &n, &info);
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
