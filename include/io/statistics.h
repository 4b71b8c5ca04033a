// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_statistics_h
#define io_statistics_h

#include <optional>

#include "evaluation/indentation_test.h"
#include "io/csv_file.h"
#include "io/screen.h"

namespace ElastoPlastic
{
  /// The tables statistics.csv (a row per nonlinear solve), history.csv and
  /// reactions.csv (a row per converged load step), and indentation.csv (a row
  /// per unloading that can be evaluated; without one there is no file).
  class Statistics
  {
  public:
    /// Creates the first three files in @p directory; reactions.csv has a
    /// column for each of @p reaction_names. @throws FileError
    Statistics(const MPI_Comm                        communicator,
               const std::string                    &directory,
               const std::vector<std::string>       &reaction_names,
               const std::optional<IndentationTest> &indentation_test);

    void
    add_solve(const SolveResult &result);

    /// @p result is that of the last solve of the step, @p reactions in the
    /// order of their names.
    void
    add_step(const SolveResult &result, const std::vector<double> &reactions);

    /// After the last step.
    void
    finish();

  private:
    void
    add_unloading(const std::optional<UnloadingResult> &result);

    const MPI_Comm    communicator;
    const std::string directory;

    CsvFile                statistics;
    CsvFile                history;
    CsvFile                reactions;
    std::optional<CsvFile> indentation;

    std::optional<IndentationTest> indentation_test;
  };
} // namespace ElastoPlastic

#endif
