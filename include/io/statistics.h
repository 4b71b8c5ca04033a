// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_statistics_h
#define io_statistics_h

#include "io/csv_file.h"
#include "io/screen.h"

namespace ElastoPlastic
{
  /// The tables statistics.csv (a row per nonlinear solve), history.csv (a row
  /// per converged load step) and mesh_changes.csv (a row per change of the
  /// mesh between two load steps).
  class Statistics
  {
  public:
    /// The number of rows of each table.
    struct Sizes
    {
      unsigned int statistics = 0, history = 0, mesh_changes = 0;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /* version */)
      {
        archive &statistics &history &mesh_changes;
      }
    };

    /// Creates the files in @p directory, or goes on after the first @p sizes
    /// rows of those that are there. @throws FileError
    Statistics(const MPI_Comm     communicator,
               const std::string &directory,
               const Sizes       &sizes);

    Sizes
    sizes() const;

    void
    add_solve(const SolveResult &result);

    /// @p result is that of the last solve of the step.
    void
    add_step(const SolveResult &result);

    /// @p before and @p after are the equilibria on the old and the new mesh
    /// under the same load; plastic work and dissipation of @p after are those
    /// of the way from one to the other.
    void
    add_mesh_change(const SolveResult &before, const SolveResult &after);

  private:
    CsvFile statistics;
    CsvFile history;
    CsvFile mesh_changes;
  };
} // namespace ElastoPlastic

#endif
