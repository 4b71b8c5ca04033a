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
    : communicator(communicator)
    , directory(directory)
    , dimension(names.dimension)
    , statistics(communicator,
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
    , mesh_changes(communicator,
                   directory + "/mesh_changes.csv",
                   mesh_change_columns(),
                   progress.mesh_changes)
    , indentation_test(indentation_test)
    , rate_test(rate_test)
  {
    if (progress.surface_profile > 0)
      make_surface_profile(progress.surface_profile);
    if (this->indentation_test)
      this->indentation_test->resume(progress.unloading);
    if (this->rate_test)
      this->rate_test->resume(progress.rates);
    if (progress.indentation > 0)
      make_indentation(progress.indentation);
    if (progress.continuous_stiffness > 0)
      make_continuous_stiffness(progress.continuous_stiffness);
    for (CsvFile *table : tables())
      table->open();
  }



  std::vector<CsvFile *>
  RunTables::tables()
  {
    std::vector<CsvFile *> result = {
      &statistics, &history, &reactions, &probes, &mesh_changes};
    if (surface_profile)
      result.push_back(&*surface_profile);
    if (indentation)
      result.push_back(&*indentation);
    if (continuous_stiffness)
      result.push_back(&*continuous_stiffness);
    return result;
  }



  RunTables::Progress
  RunTables::progress() const
  {
    return {statistics.n_rows(),
            history.n_rows(),
            reactions.n_rows(),
            probes.n_rows(),
            surface_profile ? surface_profile->n_rows() : 0,
            mesh_changes.n_rows(),
            indentation ? indentation->n_rows() : 0,
            indentation_test ? indentation_test->progress() :
                               IndentationTest::Progress(),
            rate_test ? rate_test->progress() : RateTest::Progress(),
            continuous_stiffness ? continuous_stiffness->n_rows() : 0};
  }



  void
  RunTables::write_to_disk()
  {
    for (const CsvFile *table : tables())
      table->write_to_disk();
  }



  void
  RunTables::add_solve(const SolveResult &result)
  {
    statistics.add(result);
  }



  void
  RunTables::add_step(const StepResult &result)
  {
    history.add(result.solve);
    reactions.add_rows({step_row(result.solve, result.reactions)});
    probes.add_rows({step_row(result.solve, result.probes)});
    if (!result.surface_profile.empty())
      {
        if (!surface_profile)
          {
            make_surface_profile(0);
            surface_profile->open();
          }
        surface_profile->add_all(result.surface_profile);
      }
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
  RunTables::make_surface_profile(const unsigned int n_rows)
  {
    surface_profile.emplace(communicator,
                            directory + "/surface_profile.csv",
                            surface_profile_columns(dimension),
                            n_rows);
  }



  void
  RunTables::make_indentation(const unsigned int n_rows)
  {
    indentation.emplace(communicator,
                        directory + "/indentation.csv",
                        indentation_columns(),
                        n_rows);
  }



  void
  RunTables::make_continuous_stiffness(const unsigned int n_rows)
  {
    continuous_stiffness.emplace(communicator,
                                 directory + "/continuous_stiffness.csv",
                                 continuous_stiffness_columns(),
                                 n_rows);
  }



  void
  RunTables::add_stiffness(const SolveResult &result)
  {
    if (std::isnan(result.contact_stiffness))
      return;
    if (!continuous_stiffness)
      {
        make_continuous_stiffness(0);
        continuous_stiffness->open();
      }
    continuous_stiffness->add(
      indentation_test->with_stiffness(indentation_point(result),
                                       result.contact_stiffness));
  }



  void
  RunTables::add_indentation(const std::optional<UnloadingResult> &result)
  {
    if (!result)
      return;
    if (!indentation)
      {
        make_indentation(0);
        indentation->open();
      }
    indentation->add(*result);
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
