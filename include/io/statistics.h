// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_statistics_h
#define io_statistics_h

#include <optional>

#include "io/columns.h"

namespace ElastoPlastic
{
  /// The tables statistics.csv (a row per nonlinear solve), history.csv and
  /// reactions.csv (a row per converged load step), mesh_changes.csv (a row per
  /// change of the mesh between two load steps), and indentation.csv (a row per
  /// unloading that can be evaluated; without one there is no file).
  class Statistics
  {
  public:
    /// How many rows each table has, and what has been noted of an unloading
    /// that is not over.
    struct Progress
    {
      unsigned int statistics = 0, history = 0, reactions = 0;
      unsigned int mesh_changes = 0, indentation = 0;

      IndentationTest::Progress unloading;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /* version */)
      {
        archive &statistics &history       &reactions;
        archive &mesh_changes &indentation &unloading;
      }
    };

    /// Creates the files in @p directory, or goes on after the first rows, as
    /// many as @p progress says, of those that are there; reactions.csv has a
    /// column for each of @p reaction_names. All files are looked at before
    /// the first one is touched. @throws FileError; InputError if rows are
    /// missing
    Statistics(const MPI_Comm                        communicator,
               const std::string                    &directory,
               const std::vector<std::string>       &reaction_names,
               const std::optional<IndentationTest> &indentation_test,
               const Progress                       &progress);

    Progress
    progress() const;

    /// Waits until all rows are on the disk. @throws FileError
    void
    write_to_disk();

    void
    add_solve(const SolveResult &result);

    /// @p result is that of the last solve of the step, @p reactions in the
    /// order of their names.
    void
    add_step(const SolveResult &result, const std::vector<double> &reactions);

    /// After the last step.
    void
    finish();

    /// @p before and @p after are the equilibria on the old and the new mesh
    /// under the same load; plastic work and dissipation of @p after are those
    /// of the way from one to the other.
    void
    add_mesh_change(const SolveResult &before, const SolveResult &after);

  private:
    std::vector<CsvFile *>
    tables();

    void
    make_indentation(const unsigned int n_rows);

    /// Adds the result of @p evaluate, if there is one. @throws InputError
    void
    evaluate_unloading(
      const std::function<std::optional<UnloadingResult>()> &evaluate);

    const MPI_Comm    communicator;
    const std::string directory;

    Table<SolveResult>                    statistics;
    Table<SolveResult>                    history;
    CsvFile                               reactions;
    Table<MeshChange>                     mesh_changes;
    std::optional<Table<UnloadingResult>> indentation;

    std::optional<IndentationTest> indentation_test;
  };
} // namespace ElastoPlastic

#endif
