// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_conic_lower_triangle_h
#define bounds_conic_lower_triangle_h

#include <algorithm>
#include <cstddef>
#include <memory>

namespace ElastoPlastic
{
  /// Where the entries of a matrix are that has at least as many rows as
  /// columns, and whose entries above the diagonal do not count. They are
  /// stored by tiles: of some columns, one after the other, all rows from the
  /// first of these columns on. That takes little more than what counts.
  struct LowerTrapezoid
  {
    static constexpr unsigned int n_in_tile = 256;

    unsigned int n_columns = 0;
    unsigned int n_rows    = 0; ///< not less than columns

    /// Of @p n columns or rows.
    static unsigned int
    n_tiles(const unsigned int n)
    {
      return (n + n_in_tile - 1) / n_in_tile;
    }

    unsigned int
    n_tiles() const
    {
      return n_tiles(n_columns);
    }

    /// That are stored.
    std::size_t
    n_entries() const
    {
      return begin(n_tiles());
    }

    /// Of tile @p t, the columns from its first one to before the last.
    unsigned int
    end_column(const unsigned int t) const
    {
      return std::min((t + 1) * n_in_tile, n_columns);
    }

    /// Of tile @p t, the distance between entries of the same row.
    unsigned int
    stride(const unsigned int t) const
    {
      return n_rows - t * n_in_tile;
    }

    /// Of tile @p t. The tiles before have n_rows, n_rows - n_in_tile, ...
    /// rows; all are full but the last.
    std::size_t
    begin(const unsigned int t) const
    {
      const std::size_t n_full = std::min(t, n_columns / n_in_tile);
      return n_full * n_in_tile * n_rows -
             n_full * (n_full - 1) / 2 * n_in_tile * n_in_tile +
             (t > n_full ?
                (n_columns - n_full * n_in_tile) * std::size_t(stride(n_full)) :
                0);
    }

    /// The entry on the diagonal, which those below follow.
    std::size_t
    diagonal(const unsigned int column) const
    {
      const unsigned int t = column / n_in_tile;
      return begin(t) + std::size_t(column % n_in_tile) * (stride(t) + 1);
    }
  };



  /// The lower half of a large symmetric matrix.
  class LowerTriangle
  {
  public:
    LowerTriangle() = default;

    /// For @p n columns, with any entries.
    /// @throws std::bad_alloc
    explicit LowerTriangle(const unsigned int n)
      : shape(shape_of(n))
      , entries(new double[shape.n_entries()])
    {}

    static LowerTrapezoid
    shape_of(const unsigned int n)
    {
      return {n, n};
    }

    unsigned int
    stride(const unsigned int tile) const
    {
      return shape.stride(tile);
    }

    double *
    tile(const unsigned int t) const
    {
      return entries.get() + shape.begin(t);
    }

    /// The entry on the diagonal, which those below follow.
    double *
    diagonal(const unsigned int column) const
    {
      return entries.get() + shape.diagonal(column);
    }

  private:
    LowerTrapezoid            shape;
    std::unique_ptr<double[]> entries;
  };
} // namespace ElastoPlastic

#endif
