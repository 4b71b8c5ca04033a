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
        DensePanels::solve(rows.data(),
                           front.n_rows,
                           front.n_columns,
                           columns_of(front),
                           front.n_rows);
        for (unsigned int i = 0; i < front.n_rows; ++i)
          x[front.rows[i]] = rows[i];
      }
    for (auto front = fronts.rbegin(); front != fronts.rend(); ++front)
      {
        gather(*front);
        DensePanels::solve_transposed(rows.data(),
                                      front->n_rows,
                                      front->n_columns,
                                      columns_of(*front),
                                      front->n_rows);
        for (unsigned int i = 0; i < front->n_columns; ++i)
          x[front->rows[i]] = rows[i];
      }
  }
} // namespace ElastoPlastic
