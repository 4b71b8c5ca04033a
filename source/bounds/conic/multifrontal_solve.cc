// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <vector>

#include "bounds/conic/multifrontal_factor.h"

namespace ElastoPlastic
{
  // The rows of a front are gathered, and stored again where they change.
  void
  MultifrontalFactor::solve(double *const x) const
  {
    std::vector<double> rows;
    const auto          gather = [&](const Front &front) {
      rows.resize(front.n_rows);
      for (unsigned int i = 0; i < front.n_rows; ++i)
        rows[i] = x[front.rows[i]];
    };
    for (const Front &front : fronts)
      {
        gather(front);
        for (unsigned int t = 0; t < front.n_tiles(); ++t)
          {
            const unsigned int first = t * Front::n_in_tile;
            DensePanels::solve(rows.data() + first,
                               front.n_rows - first,
                               front.end_column(t) - first,
                               columns_of(front) + front.begin(t),
                               front.stride(t));
          }
        for (unsigned int i = 0; i < front.n_rows; ++i)
          x[front.rows[i]] = rows[i];
      }
    for (auto front = fronts.rbegin(); front != fronts.rend(); ++front)
      {
        gather(*front);
        for (unsigned int t = front->n_tiles(); t-- > 0;)
          {
            const unsigned int first = t * Front::n_in_tile;
            DensePanels::solve_transposed(rows.data() + first,
                                          front->n_rows - first,
                                          front->end_column(t) - first,
                                          columns_of(*front) + front->begin(t),
                                          front->stride(t));
          }
        for (unsigned int i = 0; i < front->n_columns; ++i)
          x[front->rows[i]] = rows[i];
      }
  }
} // namespace ElastoPlastic
