// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/rethrow_collectively.h"
#include "io/statistics.h"

namespace ElastoPlastic
{
  namespace
  {
    std::vector<std::string>
    reaction_columns(const std::vector<std::string> &names)
    {
      std::vector<std::string> columns = {"step", "time"};
      columns.insert(columns.end(), names.begin(), names.end());
      return columns;
    }



    IndentationPoint
    indentation_point(const SolveResult &r)
    {
      return {r.step, r.time, r.depth, r.force, r.contact_area};
    }
  } // namespace



  Statistics::Statistics(const MPI_Comm                        communicator,
                         const std::string                    &directory,
                         const std::vector<std::string>       &reaction_names,
                         const std::optional<IndentationTest> &indentation_test,
                         const Progress                       &progress)
    : communicator(communicator)
    , directory(directory)
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
                reaction_columns(reaction_names),
                progress.reactions)
    , mesh_changes(communicator,
                   directory + "/mesh_changes.csv",
                   mesh_change_columns(),
                   progress.mesh_changes)
    , indentation_test(indentation_test)
  {
    if (this->indentation_test)
      {
        this->indentation_test->resume(progress.unloading);
        if (progress.indentation > 0)
          make_indentation(progress.indentation);
      }
    for (CsvFile *table : tables())
      table->open();
  }



  std::vector<CsvFile *>
  Statistics::tables()
  {
    std::vector<CsvFile *> result = {&statistics,
                                     &history,
                                     &reactions,
                                     &mesh_changes};
    if (indentation)
      result.push_back(&*indentation);
    return result;
  }



  Statistics::Progress
  Statistics::progress() const
  {
    return {statistics.n_rows(),
            history.n_rows(),
            reactions.n_rows(),
            mesh_changes.n_rows(),
            indentation ? indentation->n_rows() : 0,
            indentation_test ? indentation_test->progress() :
                               IndentationTest::Progress()};
  }



  void
  Statistics::write_to_disk()
  {
    for (const CsvFile *table : tables())
      table->write_to_disk();
  }



  void
  Statistics::add_solve(const SolveResult &result)
  {
    statistics.add(result);
  }



  void
  Statistics::add_step(const SolveResult         &r,
                       const std::vector<double> &reaction_forces)
  {
    history.add(r);

    std::vector<double> row = {static_cast<double>(r.step), r.time};
    row.insert(row.end(), reaction_forces.begin(), reaction_forces.end());
    reactions.add_row(row);

    evaluate_unloading(
      [&]() { return indentation_test->add(indentation_point(r)); });
  }



  void
  Statistics::finish()
  {
    evaluate_unloading([&]() { return indentation_test->finish(); });
  }



  void
  Statistics::make_indentation(const unsigned int n_rows)
  {
    indentation.emplace(communicator,
                        directory + "/indentation.csv",
                        indentation_columns(),
                        n_rows);
  }



  // The area of the tip may be an expression, which can fail.
  void
  Statistics::evaluate_unloading(
    const std::function<std::optional<UnloadingResult>()> &evaluate)
  {
    if (!indentation_test)
      return;
    std::optional<UnloadingResult> result;
    rethrow_collectively(communicator, [&]() { result = evaluate(); });
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
  Statistics::add_mesh_change(const SolveResult &before,
                              const SolveResult &after)
  {
    mesh_changes.add({before, after});
    if (indentation_test)
      indentation_test->change_mesh(indentation_point(before),
                                    indentation_point(after));
  }
} // namespace ElastoPlastic
