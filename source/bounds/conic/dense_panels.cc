// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/aligned_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "bounds/conic/multifrontal_factor.h"

// Products are computed as in the libraries (Goto and van de Geijn 2008): a few
// rows of A and a few of B are packed one column after the other, so that their
// product stays in the processor's registers.

namespace ElastoPlastic::DensePanels
{
  namespace
  {
    /// Bytes of the widest register of the processor that is compiled for,
    /// whatever deal.II was compiled for.
    constexpr unsigned int register_size = __BIGGEST_ALIGNMENT__;
    constexpr unsigned int n_lanes       = register_size / sizeof(double);

    /// With AVX-512, 24 of 32 registers hold the product; with AVX2, 12 of 16.
    constexpr unsigned int n_vectors = 3;
    constexpr unsigned int n_rows    = n_vectors * n_lanes;
    constexpr unsigned int n_columns = std::max(4u, n_lanes);

    /// So many columns of A are packed: a panel of B stays in the first cache.
    constexpr unsigned int depth = 256;

    /// The compiler leaves an array of these in registers, but not one of
    /// VectorizedArray.
    using Register [[gnu::vector_size(register_size)]] = double;

    /// One column after the other.
    struct Product
    {
      alignas(register_size) double entries[n_columns * n_rows];
    };

    using Buffer = dealii::AlignedVector<double>;



    /// The product of packed panels of A and B^T.
    [[gnu::noinline]] void
    multiply(Product           &product,
             const double      *a,
             const double      *b,
             const unsigned int k)
    {
      Register sum[n_columns][n_vectors];
      for (auto &column : sum)
        for (Register &entries : column)
          entries = Register{};
      for (unsigned int l = 0; l < k; ++l, a += n_rows, b += n_columns)
        {
          Register rows[n_vectors];
          for (unsigned int v = 0; v < n_vectors; ++v)
            std::memcpy(&rows[v], a + v * n_lanes, sizeof(Register));
          for (unsigned int c = 0; c < n_columns; ++c)
            for (unsigned int v = 0; v < n_vectors; ++v)
              sum[c][v] += rows[v] * b[c];
        }
      for (unsigned int c = 0; c < n_columns; ++c)
        for (unsigned int v = 0; v < n_vectors; ++v)
          std::memcpy(product.entries + c * n_rows + v * n_lanes,
                      &sum[c][v],
                      sizeof(Register));
    }



    /// Packs @p m rows of a matrix with @p k columns, and zeros behind them.
    template <unsigned int width>
    void
    pack(double            *panel,
         const double      *a,
         const unsigned int m,
         const unsigned int k,
         const std::size_t  stride)
    {
      for (unsigned int l = 0; l < k; ++l, a += stride, panel += width)
        if (m >= width)
          std::copy_n(a, width, panel);
        else
          std::fill(std::copy_n(a, m, panel), panel + width, 0.);
    }



    /// C -= the first m rows and n columns of the product
    void
    subtract(double            *c,
             const unsigned int m,
             const unsigned int n,
             const std::size_t  stride,
             const Product     &product)
    {
      const double *entries = product.entries;
      for (unsigned int j = 0; j < n; ++j, c += stride, entries += n_rows)
        if (m == n_rows)
          for (unsigned int i = 0; i < n_rows; ++i)
            c[i] -= entries[i];
        else
          for (unsigned int i = 0; i < m; ++i)
            c[i] -= entries[i];
    }



    /// The same for C := -product.
    void
    set_to_minus(double            *c,
                 const unsigned int m,
                 const unsigned int n,
                 const std::size_t  stride,
                 const Product     &product)
    {
      const double *entries = product.entries;
      for (unsigned int j = 0; j < n; ++j, c += stride, entries += n_rows)
        for (unsigned int i = 0; i < m; ++i)
          c[i] = -entries[i];
    }



    /// Calls store(C, rows, columns, stride, product) for each part of the
    /// lower half of C whose part of A B^T is one product. @p k is the depth at
    /// most.
    template <typename Store>
    void
    multiply_square(double            *c,
                    const unsigned int m,
                    const unsigned int n,
                    const unsigned int stride_of_c,
                    const double      *a,
                    const unsigned int k,
                    const unsigned int stride,
                    const Store       &store)
    {
      thread_local Buffer rows, columns;
      Product             product;
      rows.resize_fast(n_rows * depth);
      columns.resize_fast((n + n_columns) * depth);
      for (unsigned int j = 0; j < n; j += n_columns)
        pack<n_columns>(
          &columns[j * depth], a + j, std::min(n_columns, n - j), k, stride);
      for (unsigned int i = 0; i < m; i += n_rows)
        {
          const unsigned int height = std::min(n_rows, m - i);
          pack<n_rows>(rows.begin(), a + i, height, k, stride);
          for (unsigned int j = 0; j < n && j < i + n_rows; j += n_columns)
            {
              multiply(product, rows.begin(), &columns[j * depth], k);
              store(c + std::size_t(j) * stride_of_c + i,
                    height,
                    std::min(n_columns, n - j),
                    stride_of_c,
                    product);
            }
        }
    }



    /// X := (X - product) L^-T for packed columns of X, with the @p n columns
    /// of L that are packed in @p l.
    void
    divide_panel(double            *x,
                 const Product     &product,
                 const double      *l,
                 const unsigned int n)
    {
      for (unsigned int c = 0; c < n; ++c)
        {
          double *const column = x + c * n_rows;
          for (unsigned int i = 0; i < n_rows; ++i)
            column[i] -= product.entries[c * n_rows + i];
          for (unsigned int d = 0; d < c; ++d)
            for (unsigned int i = 0; i < n_rows; ++i)
              column[i] -= x[d * n_rows + i] * l[d * n_columns + c];
          const double inverse = 1. / l[c * n_columns + c];
          for (unsigned int i = 0; i < n_rows; ++i)
            column[i] *= inverse;
        }
    }



    /// So many columns are multiplied together with a vector: a solution with
    /// the factor then reads the vector less often than the columns.
    constexpr unsigned int n_together = 4;

    using Columns = std::array<const double *, n_together>;
    using Values  = std::array<double, n_together>;

    /// Those from @p k to before @p end, the last one repeated.
    Columns
    columns_from(const double      *l,
                 const unsigned int k,
                 const unsigned int end,
                 const unsigned int stride)
    {
      Columns columns;
      for (unsigned int c = 0; c < n_together; ++c)
        columns[c] = l + std::size_t(std::min(k + c, end - 1)) * stride;
      return columns;
    }



    /// Of the entries from @p begin to before @p end.
    Values
    products(const Columns     &columns,
             const double      *x,
             const unsigned int begin,
             const unsigned int end)
    {
      std::array<Register, n_together> sums{};
      unsigned int                     i = begin;
      for (; i + n_lanes <= end; i += n_lanes)
        {
          Register entries, of_column;
          std::memcpy(&entries, x + i, sizeof(Register));
          for (unsigned int c = 0; c < n_together; ++c)
            {
              std::memcpy(&of_column, columns[c] + i, sizeof(Register));
              sums[c] += of_column * entries;
            }
        }
      Values result{};
      for (unsigned int c = 0; c < n_together; ++c)
        {
          for (unsigned int lane = 0; lane < n_lanes; ++lane)
            result[c] += sums[c][lane];
          for (unsigned int j = i; j < end; ++j)
            result[c] += columns[c][j] * x[j];
        }
      return result;
    }
  } // namespace



  bool
  factorize(double *a, const unsigned int n, const unsigned int stride)
  {
    for (unsigned int j = 0; j < n; ++j)
      {
        double *const column = a + std::size_t(j) * stride;
        if (!(column[j] > 0))
          return false;
        column[j] = std::sqrt(column[j]);
        for (unsigned int i = j + 1; i < n; ++i)
          column[i] /= column[j];
        for (unsigned int k = j + 1; k < n; ++k)
          {
            double *const target = a + std::size_t(k) * stride;
            const double  factor = column[k];
            for (unsigned int i = k; i < n; ++i)
              target[i] -= factor * column[i];
          }
      }
    return true;
  }



  void
  divide(double            *b,
         const unsigned int m,
         const unsigned int n,
         const double      *l,
         const unsigned int stride)
  {
    thread_local Buffer packed_l, x;
    Product             product;
    packed_l.resize_fast((n + n_columns) * n);
    x.resize_fast(n_rows * n);
    for (unsigned int j = 0; j < n; j += n_columns)
      pack<n_columns>(
        &packed_l[j * n], l + j, std::min(n_columns, n - j), n, stride);
    for (unsigned int i = 0; i < m; i += n_rows)
      {
        const unsigned int height = std::min(n_rows, m - i);
        pack<n_rows>(x.begin(), b + i, height, n, stride);
        for (unsigned int j = 0; j < n; j += n_columns)
          {
            multiply(product, x.begin(), &packed_l[j * n], j);
            divide_panel(&x[j * n_rows],
                         product,
                         &packed_l[j * n + j * n_columns],
                         std::min(n_columns, n - j));
          }
        for (unsigned int j = 0; j < n; ++j)
          std::copy_n(&x[j * n_rows], height, b + i + std::size_t(j) * stride);
      }
  }



  void
  solve(double            *x,
        const unsigned int m,
        const unsigned int n,
        const double      *l,
        const unsigned int stride)
  {
    for (unsigned int k = 0; k < n; k += n_together)
      {
        const unsigned int end     = std::min(k + n_together, n);
        const Columns      columns = columns_from(l, k, end, stride);
        Values             values{};
        for (unsigned int j = k; j < end; ++j)
          {
            const double *const column = columns[j - k];
            values[j - k]              = x[j] /= column[j];
            for (unsigned int i = j + 1; i < end; ++i)
              x[i] -= column[i] * x[j];
          }
        for (unsigned int i = end; i < m; ++i)
          x[i] -= (columns[0][i] * values[0] + columns[1][i] * values[1]) +
                  (columns[2][i] * values[2] + columns[3][i] * values[3]);
      }
  }



  void
  solve_transposed(double            *x,
                   const unsigned int m,
                   const unsigned int n,
                   const double      *l,
                   const unsigned int stride)
  {
    for (unsigned int end = n, k; end > 0; end = k)
      {
        k                     = (end - 1) / n_together * n_together;
        const Columns columns = columns_from(l, k, end, stride);
        const Values  sums    = products(columns, x, end, m);
        for (unsigned int j = end; j-- > k;)
          {
            const double *const column = columns[j - k];
            x[j] -= sums[j - k];
            for (unsigned int i = j + 1; i < end; ++i)
              x[j] -= column[i] * x[i];
            x[j] /= column[j];
          }
      }
  }



  void
  set_to_minus_square(double            *c,
                      const unsigned int m,
                      const unsigned int n,
                      const unsigned int stride_of_c,
                      const double      *a,
                      const unsigned int k,
                      const unsigned int stride)
  {
    const unsigned int first = std::min(k, depth);
    multiply_square(c, m, n, stride_of_c, a, first, stride, set_to_minus);
    subtract_square(
      c, m, n, stride_of_c, a + std::size_t(first) * stride, k - first, stride);
  }



  void
  subtract_square(double            *c,
                  const unsigned int m,
                  const unsigned int n,
                  const unsigned int stride_of_c,
                  const double      *a,
                  const unsigned int k,
                  const unsigned int stride)
  {
    for (unsigned int first = 0; first < k; first += depth)
      multiply_square(c,
                      m,
                      n,
                      stride_of_c,
                      a + std::size_t(first) * stride,
                      std::min(depth, k - first),
                      stride,
                      subtract);
  }
} // namespace ElastoPlastic::DensePanels
