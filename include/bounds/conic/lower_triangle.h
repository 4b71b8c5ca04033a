// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_lower_triangle_h
#define bounds_conic_lower_triangle_h

#include <algorithm>
#include <cstddef>
#include <memory>

namespace ElastoPlastic
{
  /// The lower half of a large symmetric matrix, by tiles: of some columns, one
  /// after the other, all rows from the first of these columns on. That takes
  /// little more than half of the matrix.
  class LowerTriangle
  {
  public:
    static constexpr unsigned int n_in_tile = 256;

    LowerTriangle() = default;

    /// For @p n columns, with any entries.
    /// @throws std::bad_alloc
    explicit LowerTriangle(const unsigned int n)
      : n(n)
      , entries(new double[n_entries(n)])
    {}

    static unsigned int
    n_tiles(const unsigned int n)
    {
      return (n + n_in_tile - 1) / n_in_tile;
    }

    /// That are stored.
    static std::size_t
    n_entries(const unsigned int n)
    {
      return begin_of_tile(n, n_tiles(n));
    }

    /// Of tile @p t, the distance between entries of the same row.
    unsigned int
    stride(const unsigned int t) const
    {
      return n - t * n_in_tile;
    }

    double *
    tile(const unsigned int t) const
    {
      return entries.get() + begin_of_tile(n, t);
    }

    /// The entry on the diagonal, which those below follow.
    double *
    diagonal(const unsigned int column) const
    {
      const unsigned int t = column / n_in_tile, c = column % n_in_tile;
      return tile(t) + std::size_t(c) * (stride(t) + 1);
    }

  private:
    /// The tiles before have n, n - n_in_tile, ... rows, and as many columns as
    /// rows if there are no more.
    static std::size_t
    begin_of_tile(const unsigned int n, const unsigned int t)
    {
      const std::size_t n_full = std::min(t, n / n_in_tile),
                        rest   = n - n_full * n_in_tile;
      return n_full * n_in_tile * n -
             n_full * (n_full - 1) / 2 * n_in_tile * n_in_tile +
             (t > n_full ? rest * rest : 0);
    }

    unsigned int              n = 0;
    std::unique_ptr<double[]> entries;
  };
} // namespace ElastoPlastic

#endif
