// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_dense_panels_h
#define bounds_conic_dense_panels_h

/// The steps of a Cholesky factorisation of large dense matrices, which are
/// stored by columns, @p stride numbers apart; only their lower halves are
/// read. What they do is what dpotrf, dtrsm and dsyrk of LAPACK and BLAS do, at
/// about the same speed. But not every BLAS can be called by several threads at
/// a time (Debian's libopenblas0-serial returns wrong numbers), and rounding
/// errors of the BLAS depend on the processor.
namespace ElastoPlastic::DensePanels
{
  /// A := L for the n x n matrix A = L L^T, where n is small: the other
  /// functions are for large ones. @return false if A is not positive definite.
  bool
  factorize(double *a, const unsigned int n, const unsigned int stride);

  /// B := B L^-T for an m x n matrix B
  void
  divide(double            *b,
         const unsigned int m,
         const unsigned int n,
         const double      *l,
         const unsigned int stride);

  /// The lower half of C -= A B^T for an m x k matrix A, the first n rows of
  /// which are B. Above the diagonal of C, anything may result.
  void
  subtract_square(double            *c,
                  const unsigned int m,
                  const unsigned int n,
                  const unsigned int stride_of_c,
                  const double      *a,
                  const unsigned int k,
                  const unsigned int stride);
} // namespace ElastoPlastic::DensePanels

#endif
