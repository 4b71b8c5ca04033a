// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <new>

#include "bounds/conic/multifrontal_factor.h"

namespace ElastoPlastic
{
  namespace
  {
    using Rows = MultifrontalFactor::Rows;

    /// So many columns are eliminated at a time, and so many rows or columns of
    /// a front are left to a thread.
    constexpr unsigned int n_together = 64;
    constexpr unsigned int n_in_tile  = LowerTrapezoid::n_in_tile;



    /// Runs @p action for all numbers below @p n, so many at a time by
    /// different threads. (If one thread would do all, none is begun: that
    /// would cost more than most fronts.)
    template <typename Action>
    void
    in_parallel(const unsigned int n,
                const unsigned int n_at_a_time,
                const Action      &action)
    {
      if (n <= n_at_a_time)
        for (unsigned int i = 0; i < n; ++i)
          action(i);
      else
#pragma omp parallel for schedule(dynamic, n_at_a_time)
        for (unsigned int i = 0; i < n; ++i)
          action(i);
    }



    /// Adds the columns from @p first to before @p end of a child's @p update
    /// to the lower half of a matrix. Of the latter, @p diagonal tells where
    /// the entry of a column of the front is, which those of the next rows
    /// follow.
    template <typename Diagonal>
    void
    add_columns(const LowerTriangle     &update,
                const std::vector<Rows> &common,
                const unsigned int       first,
                const unsigned int       end,
                const Diagonal          &diagonal)
    {
      in_parallel(common.size(), n_together, [&](const unsigned int k) {
        for (unsigned int j = std::max(common[k].begin, first);
             j < std::min(common[k].end, end);
             ++j)
          {
            const unsigned int  column = j + common[k].shift;
            const double *const source = update.diagonal(j);
            double *const       target = diagonal(column);
            for (unsigned int l = k; l < common.size(); ++l)
              {
                const unsigned int begin = std::max(j, common[l].begin);
                const unsigned int shift = common[l].shift - common[k].shift;
                for (unsigned int i = begin - j; i < common[l].end - j; ++i)
                  target[i + shift] += source[i];
              }
          }
      });
    }
  } // namespace



  std::vector<MultifrontalFactor::Rows>
  MultifrontalFactor::rows_in_common(const Front &child, const Front &front)
  {
    std::vector<Rows> result;
    unsigned int      row = 0;
    for (unsigned int i = 0; i < child.n_updated(); ++i, ++row)
      {
        while (front.rows[row] != child.rows[child.n_columns + i])
          ++row;
        if (result.empty() || row - i != result.back().shift)
          result.push_back({i, i, row - i});
        ++result.back().end;
      }
    return result;
  }



  unsigned int
  MultifrontalFactor::n_columns_in_common(const Front &child,
                                          const Front &front)
  {
    const auto *const begin = child.rows + child.n_columns;
    return std::lower_bound(begin,
                            child.rows + child.n_rows,
                            front.rows[0] + front.n_columns) -
           begin;
  }



  void
  MultifrontalFactor::assemble_columns(const Front &front)
  {
    double *const columns = columns_of(front);
    for (const unsigned int c : front.children)
      add_columns(updates[c],
                  rows_in_common(fronts[c], front),
                  0,
                  n_columns_in_common(fronts[c], front),
                  [&](const unsigned int column) {
                    return columns + front.diagonal(column);
                  });
  }



  // The children's updates end here.
  void
  MultifrontalFactor::assemble_update(const unsigned int f)
  {
    for (const unsigned int c : fronts[f].children)
      {
        add_columns(updates[c],
                    rows_in_common(fronts[c], fronts[f]),
                    n_columns_in_common(fronts[c], fronts[f]),
                    fronts[c].n_updated(),
                    [&](const unsigned int column) {
                      return updates[f].diagonal(column - fronts[f].n_columns);
                    });
        updates[c] = LowerTriangle();
      }
  }



  bool
  MultifrontalFactor::eliminate(const Front &front)
  {
    double *const columns = columns_of(front);
    for (unsigned int k = 0; k < front.n_columns; k += n_together)
      {
        const unsigned int end      = std::min(k + n_together, front.n_columns);
        const unsigned int below    = front.n_rows - end;
        const unsigned int stride   = front.stride(k / n_in_tile);
        double *const      diagonal = columns + front.diagonal(k);
        if (!DensePanels::factorize(diagonal, end - k, stride))
          return false;
        in_parallel(Front::n_tiles(below), 1, [&](const unsigned int t) {
          DensePanels::divide(diagonal + end - k + t * n_in_tile,
                              std::min(n_in_tile, below - t * n_in_tile),
                              end - k,
                              diagonal,
                              stride);
        });
        const unsigned int next =
          end < front.n_columns ? end / n_in_tile : front.n_tiles();
        in_parallel(front.n_tiles() - next, 1, [&](const unsigned int i) {
          const unsigned int t     = next + i;
          const unsigned int first = std::max(end, t * n_in_tile);
          DensePanels::subtract_square(columns + front.diagonal(first),
                                       front.n_rows - first,
                                       front.end_column(t) - first,
                                       front.stride(t),
                                       diagonal + first - k,
                                       end - k,
                                       stride);
        });
      }
    return true;
  }



  void
  MultifrontalFactor::find_update(const unsigned int f)
  {
    const Front       &front  = fronts[f];
    const unsigned int n      = front.n_updated();
    LowerTriangle     &update = updates[f] = LowerTriangle(n);
    in_parallel(Front::n_tiles(n), 1, [&](const unsigned int t) {
      const unsigned int first = t * n_in_tile;
      for (unsigned int of_front = 0; of_front < front.n_tiles(); ++of_front)
        {
          const unsigned int before = of_front * n_in_tile;
          const auto change = of_front == 0 ? DensePanels::set_to_minus_square :
                                              DensePanels::subtract_square;
          change(update.tile(t),
                 n - first,
                 std::min(n_in_tile, n - first),
                 update.stride(t),
                 columns_of(front) + front.begin(of_front) + front.n_columns -
                   before + first,
                 front.end_column(of_front) - before,
                 front.stride(of_front));
        }
    });
  }



  bool
  MultifrontalFactor::eliminate(const unsigned int f)
  {
    assemble_columns(fronts[f]);
    if (!eliminate(fronts[f]))
      return false;
    find_update(f);
    assemble_update(f);
    return true;
  }



  // (No exception may leave a part that threads share.)
  bool
  MultifrontalFactor::eliminate_by_parts()
  {
    bool is_positive = true, has_memory = true;
#pragma omp parallel for schedule(dynamic) \
  reduction(&& : is_positive, has_memory)
    for (unsigned int p = 0; p < parts.size(); ++p)
      try
        {
          for (unsigned int f = fronts[parts[p]].first;
               is_positive && f <= parts[p];
               ++f)
            is_positive = eliminate(f);
        }
      catch (const std::bad_alloc &)
        {
          has_memory = false;
        }
    if (!has_memory)
      throw std::bad_alloc();
    for (unsigned int i = 0; is_positive && i < last_fronts.size(); ++i)
      is_positive = eliminate(last_fronts[i]);
    return is_positive;
  }



  bool
  MultifrontalFactor::factorize()
  {
    bool is_positive = true;
    if (is_alone())
      for (unsigned int f = 0; is_positive && f < fronts.size(); ++f)
        is_positive = eliminate(f);
    else
      is_positive = eliminate_by_parts();
    for (LowerTriangle &update : updates)
      update = LowerTriangle(); // (what is left if it is not)
    return is_positive;
  }
} // namespace ElastoPlastic
