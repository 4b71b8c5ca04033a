// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <new>
#include <numeric>
#include <utility>

#include "bounds/conic/multifrontal_factor.h"

#include <omp.h>

namespace ElastoPlastic
{
  namespace
  {
    /// So many columns are eliminated at a time, and so many rows or columns of
    /// a front are left to a thread.
    constexpr unsigned int n_together = 64;
    constexpr unsigned int n_in_tile  = 256;

    /// Parts of the matrix that are left to a thread take at most this share of
    /// all work.
    constexpr double largest_part = 1. / 32;



    unsigned int
    n_tiles(const unsigned int n)
    {
      return (n + n_in_tile - 1) / n_in_tile;
    }



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



    /// The lower half of C -= A B^T by tiles of columns of C, see
    /// DensePanels::subtract_square().
    void
    subtract_square(double            *c,
                    const unsigned int m,
                    const unsigned int n,
                    const unsigned int stride_of_c,
                    const double      *a,
                    const unsigned int k,
                    const unsigned int stride)
    {
      in_parallel(n_tiles(n), 1, [&](const unsigned int t) {
        const unsigned int first = t * n_in_tile;
        DensePanels::subtract_square(c + std::size_t(first) * stride_of_c +
                                       first,
                                     m - first,
                                     std::min(n_in_tile, n - first),
                                     stride_of_c,
                                     a + first,
                                     k,
                                     stride);
      });
    }
  } // namespace



  MultifrontalFactor::MultifrontalFactor(cholmod_factor &factor)
    : factor(factor)
  {
    const auto *const columns =
      static_cast<const SuiteSparse_long *>(factor.super);
    const auto *const rows = static_cast<const SuiteSparse_long *>(factor.pi);
    const auto *const entries =
      static_cast<const SuiteSparse_long *>(factor.px);
    const auto *const numbers = static_cast<const SuiteSparse_long *>(factor.s);

    std::vector<unsigned int> front_of(factor.n);
    for (unsigned int f = 0; f < factor.nsuper; ++f)
      {
        std::fill(front_of.begin() + columns[f],
                  front_of.begin() + columns[f + 1],
                  f);
        Front &front    = fronts.emplace_back();
        front.n_columns = columns[f + 1] - columns[f];
        front.n_rows    = rows[f + 1] - rows[f];
        front.begin     = entries[f];
        front.rows      = numbers + rows[f];
        front.first     = f;
        updates.emplace_back(nullptr, &std::free);
      }
    for (unsigned int f = 0; f < fronts.size(); ++f)
      {
        Front &front = fronts[f];
        front.work +=
          static_cast<double>(front.n_columns) * front.n_rows * front.n_rows;
        if (front.n_updated() == 0)
          continue;
        Front &parent = fronts[front_of[front.rows[front.n_columns]]];
        parent.children.push_back(f);
        parent.first = std::min(parent.first, front.first);
        parent.work += front.work;
      }
    divide_among_threads();
  }



  void
  MultifrontalFactor::UpdatesHeld::eliminate(const std::vector<Front> &fronts,
                                             const unsigned int        f)
  {
    const auto size = [&](const unsigned int i) {
      return static_cast<double>(fronts[i].n_updated()) * fronts[i].n_updated();
    };
    now += size(f);
    most = std::max(most, now);
    for (const unsigned int child : fronts[f].children)
      now -= size(child);
  }



  // CHOLMOD numbers the fronts so that those below a front are all those
  // between its first one and itself.
  void
  MultifrontalFactor::divide_among_threads()
  {
    double total = 0;
    for (const Front &front : fronts)
      if (front.n_updated() == 0)
        total += front.work;
    const auto is_large = [&](const Front &front) {
      return front.work > largest_part * total;
    };
    std::vector<bool> is_below(fronts.size(), false);
    for (unsigned int f = fronts.size(); f-- > 0;)
      {
        for (const unsigned int child : fronts[f].children)
          is_below[child] = !is_large(fronts[f]);
        if (is_large(fronts[f]))
          last_fronts.insert(last_fronts.begin(), f);
        else if (!is_below[f])
          parts.push_back(f);
      }
    std::stable_sort(parts.begin(),
                     parts.end(),
                     [&](const auto a, const auto b) {
                       return fronts[a].work > fronts[b].work;
                     });
  }



  // Each thread treats one part at a time, and what parts leave behind for the
  // last fronts is kept until all are done.
  double
  MultifrontalFactor::workspace() const
  {
    double              left = 0;
    std::vector<double> beside;
    for (const unsigned int p : parts)
      {
        UpdatesHeld held;
        for (unsigned int f = fronts[p].first; f <= p; ++f)
          held.eliminate(fronts, f);
        left += held.now;
        beside.push_back(held.most - held.now);
      }
    std::sort(beside.begin(), beside.end(), std::greater<>());
    beside.resize(std::min<std::size_t>(beside.size(), omp_get_max_threads()));

    UpdatesHeld held{left, std::accumulate(beside.begin(), beside.end(), left)};
    for (const unsigned int f : last_fronts)
      held.eliminate(fronts, f);
    return sizeof(double) * held.most;
  }



  std::vector<std::size_t>
  MultifrontalFactor::positions(const dealii::SparsityPattern &pattern) const
  {
    const auto *const order =
      static_cast<const SuiteSparse_long *>(factor.Perm);
    std::vector<int> place(factor.n);
    for (unsigned int i = 0; i < factor.n; ++i)
      place[order[i]] = i;
    std::vector<unsigned int> front_of(factor.n);
    for (unsigned int f = 0; f < fronts.size(); ++f)
      for (unsigned int i = 0; i < fronts[f].n_columns; ++i)
        front_of[fronts[f].rows[i]] = f;

    std::vector<std::size_t> result;
    result.reserve(pattern.n_nonzero_elements());
    for (unsigned int i = 0; i < pattern.n_rows(); ++i)
      for (auto entry = pattern.begin(i); entry != pattern.end(i); ++entry)
        if (entry->column() <= i)
          {
            const auto [column, row] =
              std::minmax(place[i], place[entry->column()]);
            const Front      &front           = fronts[front_of[column]];
            const std::size_t column_of_front = column - front.rows[0];
            const std::size_t row_of_front =
              std::lower_bound(front.rows, front.rows + front.n_rows, row) -
              front.rows;
            result.push_back(front.begin + column_of_front * front.n_rows +
                             row_of_front);
          }
    return result;
  }



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



  void
  MultifrontalFactor::assemble(const unsigned int f)
  {
    const Front      &front   = fronts[f];
    const std::size_t n       = front.n_updated();
    double *const     columns = static_cast<double *>(factor.x) + front.begin;
    if (n > 0)
      {
        updates[f].reset(
          static_cast<double *>(std::calloc(n * n, sizeof(double))));
        if (!updates[f])
          throw std::bad_alloc();
      }
    double *const updated = updates[f].get();
    for (const unsigned int c : front.children)
      {
        const Front            &child  = fronts[c];
        const unsigned int      size   = child.n_updated();
        const double *const     values = updates[c].get();
        const std::vector<Rows> common = rows_in_common(child, front);
        in_parallel(common.size(), n_together, [&](const unsigned int k) {
          for (unsigned int j = common[k].begin; j < common[k].end; ++j)
            {
              const std::size_t column = j + common[k].shift;
              double *const     target =
                column < front.n_columns ?
                      columns + column * front.n_rows :
                      updated + (column - front.n_columns) * n - front.n_columns;
              const double *const source = values + std::size_t(j) * size;
              for (unsigned int l = k; l < common.size(); ++l)
                for (unsigned int i = std::max(j, common[l].begin);
                     i < common[l].end;
                     ++i)
                  target[i + common[l].shift] += source[i];
            }
        });
        updates[c].reset();
      }
  }



  bool
  MultifrontalFactor::eliminate(const Front &front)
  {
    double *const begin = static_cast<double *>(factor.x) + front.begin;
    for (unsigned int k = 0; k < front.n_columns; k += n_together)
      {
        const unsigned int n        = std::min(n_together, front.n_columns - k);
        const unsigned int below    = front.n_rows - k - n;
        const unsigned int rest     = front.n_columns - k - n;
        double *const      diagonal = begin + std::size_t(k) * front.n_rows + k;
        if (!DensePanels::factorize(diagonal, n, front.n_rows))
          return false;
        in_parallel(n_tiles(below), 1, [&](const unsigned int t) {
          DensePanels::divide(diagonal + n + t * n_in_tile,
                              std::min(n_in_tile, below - t * n_in_tile),
                              n,
                              diagonal,
                              front.n_rows);
        });
        subtract_square(diagonal + std::size_t(n) * front.n_rows + n,
                        below,
                        rest,
                        front.n_rows,
                        diagonal + n,
                        n,
                        front.n_rows);
      }
    return true;
  }



  void
  MultifrontalFactor::update(const unsigned int f)
  {
    const Front        &front = fronts[f];
    const unsigned int  n     = front.n_updated();
    const double *const rows =
      static_cast<const double *>(factor.x) + front.begin + front.n_columns;
    subtract_square(
      updates[f].get(), n, n, n, rows, front.n_columns, front.n_rows);
  }



  bool
  MultifrontalFactor::eliminate(const unsigned int f)
  {
    assemble(f);
    if (!eliminate(fronts[f]))
      return false;
    update(f);
    return true;
  }



  // (No exception may leave a part that threads share.)
  bool
  MultifrontalFactor::factorize()
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
    for (Update &update : updates)
      update.reset(); // (what is left if it is not)
    return is_positive;
  }
} // namespace ElastoPlastic
