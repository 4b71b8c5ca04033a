// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_run_tables_h
#define output_run_tables_h

#include <optional>

#include "evaluation/rate_test.h"
#include "output/columns.h"

namespace ElastoPlastic
{
  /// What the tables say of a load step that has converged.
  struct StepResult
  {
    /// What the last solve has found.
    const SolveResult &solve;
    /// In the order of their names.
    std::vector<double> reactions, probes;
    /// Empty if it is not written for this step.
    std::vector<SurfaceRow> surface_profile;
  };



  /// The tables statistics.csv (a row per nonlinear solve), history.csv,
  /// reactions.csv and probes.csv (a row per converged load step),
  /// surface_profile.csv (a row per point of the contact surface, for some
  /// steps), mesh_changes.csv (a row per change of the mesh between two load
  /// steps), indentation.csv (a row per unloading, hold and jump of the rate
  /// that can be evaluated), and continuous_stiffness.csv (a row per load step
  /// with a contact stiffness). Without rows there is none of
  /// surface_profile.csv, indentation.csv and continuous_stiffness.csv.
  class RunTables
  {
  public:
    /// How many rows each table has, and what has been noted of an unloading
    /// that is not over.
    struct Progress
    {
      unsigned int statistics = 0, history = 0, reactions = 0, probes = 0;
      unsigned int surface_profile = 0, mesh_changes = 0, indentation = 0;

      IndentationTest::Progress unloading;
      RateTest::Progress        rates;

      unsigned int continuous_stiffness = 0;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /* version */)
      {
        archive &statistics &history &reactions                        &probes;
        archive &surface_profile &mesh_changes &indentation &unloading &rates;
        archive &continuous_stiffness;
      }
    };

    /// What the columns depend on.
    struct Names
    {
      unsigned int             dimension;
      std::vector<std::string> reactions, probes;
    };

    /// Creates the files in @p directory, or goes on after the first rows, as
    /// many as @p progress says, of those that are there. All files are looked
    /// at before the first one is touched. @throws FileError; InputError if
    /// rows are missing
    RunTables(const MPI_Comm                        communicator,
              const std::string                    &directory,
              const Names                          &names,
              const std::optional<IndentationTest> &indentation_test,
              const std::optional<RateTest>        &rate_test,
              const Progress                       &progress);

    Progress
    progress() const;

    /// Waits until all rows are on the disk. @throws FileError
    void
    write_to_disk();

    void
    add_solve(const SolveResult &result)
    {
      statistics.add(result);
    }

    void
    add_step(const StepResult &result);

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

    /// If a stiffness has been found in this step. @throws InputError
    void
    add_stiffness(const SolveResult &result);

    /// Adds @p result, if there is one. @throws InputError
    void
    add_indentation(const std::optional<UnloadingResult> &result);

    CsvTable<SolveResult>             statistics;
    CsvTable<SolveResult>             history;
    CsvFile                           reactions;
    CsvFile                           probes;
    OptionalCsvTable<SurfaceRow>      surface_profile;
    CsvTable<MeshChange>              mesh_changes;
    OptionalCsvTable<UnloadingResult> indentation, continuous_stiffness;

    std::optional<IndentationTest> indentation_test;
    std::optional<RateTest>        rate_test;
  };
} // namespace ElastoPlastic

#endif
