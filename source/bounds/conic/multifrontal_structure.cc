// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "bounds/conic/multifrontal_factor.h"

#include <omp.h>

// What is known of the fronts before they have entries.

namespace ElastoPlastic
{
  namespace
  {
    /// Parts of the matrix that are left to a thread take at most this share of
    /// all work.
    constexpr double largest_share = 1. / 32;
  } // namespace



  MultifrontalFactor::MultifrontalFactor(const cholmod_factor &factor)
    : places(factor.n)
    , front_of(factor.n)
  {
    const auto *const columns =
      static_cast<const SuiteSparse_long *>(factor.super);
    const auto *const rows = static_cast<const SuiteSparse_long *>(factor.pi);
    const auto *const numbers = static_cast<const SuiteSparse_long *>(factor.s);

    const auto *const order =
      static_cast<const SuiteSparse_long *>(factor.Perm);
    for (unsigned int i = 0; i < factor.n; ++i)
      places[order[i]] = i;
    for (unsigned int f = 0; f < factor.nsuper; ++f)
      {
        std::fill(front_of.begin() + columns[f],
                  front_of.begin() + columns[f + 1],
                  f);
        Front &front      = fronts.emplace_back();
        front.n_columns   = columns[f + 1] - columns[f];
        front.n_rows      = rows[f + 1] - rows[f];
        front.first_entry = n_entries;
        front.rows        = numbers + rows[f];
        front.first       = f;
        n_entries += front.n_entries();
        updates.emplace_back();
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
      return static_cast<double>(
        LowerTriangle::shape_of(fronts[i].n_updated()).n_entries());
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
      return front.work > largest_share * total;
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



  bool
  MultifrontalFactor::is_alone()
  {
    return omp_get_max_threads() == 1;
  }



  // Each thread treats one part at a time, and what parts leave behind for the
  // last fronts is kept until all are done.
  double
  MultifrontalFactor::workspace() const
  {
    if (is_alone())
      {
        UpdatesHeld held;
        for (unsigned int f = 0; f < fronts.size(); ++f)
          held.eliminate(fronts, f);
        return sizeof(double) * held.most;
      }

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



  double
  MultifrontalFactor::memory() const
  {
    return sizeof(double) * static_cast<double>(n_entries);
  }



  void
  MultifrontalFactor::clear()
  {
    if (!entries)
      entries.reset(new double[n_entries]);
    std::fill_n(entries.get(), n_entries, 0.);
  }



  double &
  MultifrontalFactor::entry(const unsigned int i, const unsigned int j)
  {
    const auto [column, row]           = std::minmax(places[i], places[j]);
    const Front       &front           = fronts[front_of[column]];
    const unsigned int column_of_front = column - front.rows[0];
    const unsigned int row_of_front =
      std::lower_bound(front.rows, front.rows + front.n_rows, row) - front.rows;
    return columns_of(
      front)[front.diagonal(column_of_front) + row_of_front - column_of_front];
  }
} // namespace ElastoPlastic
