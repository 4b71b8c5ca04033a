// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_statistics_h
#define io_statistics_h

#include "io/csv_file.h"
#include "io/screen.h"

namespace ElastoPlastic
{
  /// The tables statistics.csv (a row per nonlinear solve) and history.csv (a
  /// row per converged load step).
  class Statistics
  {
  public:
    /// Creates both files in @p directory. @throws FileError
    Statistics(const MPI_Comm communicator, const std::string &directory);

    void
    add_solve(const SolveResult &result);

    /// @p result is that of the last solve of the step.
    void
    add_step(const SolveResult &result);

  private:
    CsvFile statistics;
    CsvFile history;
  };
} // namespace ElastoPlastic

#endif
