// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_log_h
#define output_log_h

#include <deal.II/base/conditional_ostream.h>

#include <set>
#include <string>

#include "base/enum_names.h"
#include "evaluation/solve_result.h"
#include "solver/semismooth_newton.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// What has made a result, in two lines that end with a line break and begin
  /// with @p prefix: program, revision and kind of build; deal.II, width of its
  /// batches and number of ranks. parameters.prm begins with them.
  std::string
  versions(const unsigned int n_ranks, const std::string &prefix = "");



  /// How much is printed; see the entry "Screen".
  enum class Verbosity
  {
    full,
    summary,
    quiet
  };

  template <>
  inline const EnumNames<Verbosity> enum_names<Verbosity> = {
    {"full", Verbosity::full},
    {"summary", Verbosity::summary},
    {"quiet", Verbosity::quiet}};



  /// Tells the user what is going on: on the screen, from the first rank only,
  /// as much as the entry "Output/Screen" allows.
  class Log
  {
  public:
    Log(const MPI_Comm communicator, const Verbosity verbosity);

    /// Program, libraries, build and number of ranks.
    void
    print_banner(const unsigned int n_ranks);

    void
    begin_solve(const SolveResult &sizes);

    void
    newton_step(const NewtonStep &step);

    void
    end_solve(const SolveResult &result);

    /// A remark that only the full output shows.
    void
    remark(const std::string &text)
    {
      full << text << std::endl;
    }

    /// A row of the table that is all that the summary shows; the first one
    /// stands below the names of the columns.
    void
    table_row(const std::string &names, const std::string &row);

    /// Something unexpected that does not stop the program: one line on
    /// standard error, however quiet the program is to be.
    void
    warn(const std::string &text)
    {
      warnings << "Warning: " << text << std::endl;
    }

    /// The same, unless that has been said.
    void
    warn_once(const std::string &text);

    /// For the table of times.
    ConditionalOStream &
    full_stream()
    {
      return full;
    }

  private:
    ConditionalOStream    full;
    ConditionalOStream    summary;
    ConditionalOStream    warnings;
    std::set<std::string> said;
    bool                  table_has_begun = false;
  };
} // namespace ElastoPlastic

#endif
