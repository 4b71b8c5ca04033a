// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "output/run_tables.h"

namespace ElastoPlastic
{
  namespace
  {
    std::vector<std::string>
    step_columns(const std::vector<std::string> &names)
    {
      std::vector<std::string> columns = {"step", "time"};
      columns.insert(columns.end(), names.begin(), names.end());
      return columns;
    }



    std::vector<double>
    step_row(const SolveResult &result, const std::vector<double> &values)
    {
      std::vector<double> row = {static_cast<double>(result.step), result.time};
      row.insert(row.end(), values.begin(), values.end());
      return row;
    }



    IndentationPoint
    indentation_point(const SolveResult &r)
    {
      return {r.step,
              r.time,
              r.depth,
              r.force,
              r.contact_area,
              r.contact_radius,
              r.pile_up};
    }
  } // namespace



  RunTables::RunTables(const MPI_Comm                        communicator,
                       const std::string                    &directory,
                       const Names                          &names,
                       const std::optional<IndentationTest> &indentation_test,
                       const std::optional<RateTest>        &rate_test,
                       const Progress                       &progress)
    : statistics(communicator,
                 directory + "/statistics.csv",
                 statistics_columns(),
                 progress.statistics)
    , history(communicator,
              directory + "/history.csv",
              history_columns(),
              progress.history)
    , reactions(communicator,
                directory + "/reactions.csv",
                step_columns(names.reactions),
                progress.reactions)
    , probes(communicator,
             directory + "/probes.csv",
             step_columns(names.probes),
             progress.probes)
    , surface_profile(communicator,
                      directory + "/surface_profile.csv",
                      surface_profile_columns(names.dimension),
                      progress.surface_profile)
    , mesh_changes(communicator,
                   directory + "/mesh_changes.csv",
                   mesh_change_columns(),
                   progress.mesh_changes)
    , indentation(communicator,
                  directory + "/indentation.csv",
                  indentation_columns(),
                  progress.indentation)
    , continuous_stiffness(communicator,
                           directory + "/continuous_stiffness.csv",
                           continuous_stiffness_columns(),
                           progress.continuous_stiffness)
    , indentation_test(indentation_test)
    , rate_test(rate_test)
  {
    if (this->indentation_test)
      this->indentation_test->resume(progress.unloading);
    if (this->rate_test)
      this->rate_test->resume(progress.rates);
    for (CsvFile *table : tables())
      table->open();
  }



  std::vector<CsvFile *>
  RunTables::tables()
  {
    std::vector<CsvFile *> result = {
      &statistics, &history, &reactions, &probes, &mesh_changes};
    for (CsvFile *const file : {surface_profile.file(),
                                indentation.file(),
                                continuous_stiffness.file()})
      if (file)
        result.push_back(file);
    return result;
  }



  RunTables::Progress
  RunTables::progress() const
  {
    return {statistics.n_rows(),
            history.n_rows(),
            reactions.n_rows(),
            probes.n_rows(),
            surface_profile.n_rows(),
            mesh_changes.n_rows(),
            indentation.n_rows(),
            indentation_test ? indentation_test->progress() :
                               IndentationTest::Progress(),
            rate_test ? rate_test->progress() : RateTest::Progress(),
            continuous_stiffness.n_rows()};
  }



  void
  RunTables::write_to_disk()
  {
    for (const CsvFile *table : tables())
      table->write_to_disk();
  }



  void
  RunTables::add_step(const StepResult &result)
  {
    history.add(result.solve);
    reactions.add_rows({step_row(result.solve, result.reactions)});
    probes.add_rows({step_row(result.solve, result.probes)});
    surface_profile.add_all(result.surface_profile);

    const IndentationPoint point = indentation_point(result.solve);
    if (!indentation_test)
      return;
    add_stiffness(result.solve);
    add_indentation(indentation_test->add(point));
    if (rate_test)
      if (const auto sensitivity = rate_test->add(point))
        add_indentation(
          sensitivity->row(indentation_test->part_of_surroundings()));
  }



  void
  RunTables::finish()
  {
    if (indentation_test)
      add_indentation(indentation_test->finish());
  }



  void
  RunTables::add_stiffness(const SolveResult &result)
  {
    if (!std::isnan(result.contact_stiffness))
      continuous_stiffness.add_all(
        {indentation_test->with_stiffness(indentation_point(result),
                                          result.contact_stiffness)});
  }



  void
  RunTables::add_indentation(const std::optional<UnloadingResult> &result)
  {
    if (result)
      indentation.add_all({*result});
  }



  void
  RunTables::add_mesh_change(const SolveResult &before,
                             const SolveResult &after)
  {
    mesh_changes.add({before, after});
    if (indentation_test)
      indentation_test->change_mesh(indentation_point(before),
                                    indentation_point(after));
    if (rate_test)
      rate_test->change_mesh(indentation_point(before),
                             indentation_point(after));
  }
} // namespace ElastoPlastic
