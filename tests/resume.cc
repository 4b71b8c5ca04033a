// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// A run that is resumed with a longer history gives the tables of one that has
// had it from the beginning: with steps that adapt, with meshes that follow the
// contact, with two-step integration, where the control changes, and after a
// first step whose next mesh would have been too large. So does a run that has
// failed and goes on with more cuts. Tables that are not what the interrupted
// run has left are refused, and so are histories that have not begun alike.

#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include "app/program.h"
#include "table.h"
#include "verdict.h"

using namespace ElastoPlastic;
namespace fs = std::filesystem;

namespace
{
  /// Six steps.
  const std::string input = R"(
set Dimension = 2
subsection Geometry
  set Type                = box
  set Lower corner        = 0, -4
  set Upper corner        = 4, 0
  set Initial refinements = 3
end
subsection Boundary conditions
  set Fixed   = bottom
  set Roller  = left
  set Free    = right
  set Contact = top
end
subsection Material
  set Law                         = combined hardening
  set Isotropic hardening modulus = 1000
  set Kinematic hardening modulus = 1000
end
subsection Indenter
  set Type     = cylinder
  set Radius   = 5
  set Position = 0
end
subsection Loading
  set History         = 1: depth 0.03 | 2: force 10 | 3: depth 0.04
  set Number of steps = 6
end
subsection Refinement
  set Strategy                   = Kelly
  set Refinement fraction        = 0.1
  set Coarsening fraction        = 0.3
  set Number of cycles           = 5
  set Maximum number of unknowns = 260
end
subsection Nonlinear solver
  set Tolerance = 1e-12
end
subsection Output
  set Directory       = results
  set Fields          = never
  set Surface profile = every step
  set Probe points    = below: 0.1, -0.3 | side: 4, 0
end
)";



  using Entries = std::vector<std::string>;

  /// The first four of them.
  const Entries first_part = {"Loading/History=1: depth 0.03 | 2: force 10",
                              "Loading/Number of steps=4"};



  Entries
  both(Entries a, const Entries &b)
  {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }



  /// @return the exit status, and what the program has to say on standard
  /// error.
  std::pair<int, std::string>
  run(const std::string &option, const Entries &entries)
  {
    std::vector<const char *> arguments = {"elasto_plastic_contact",
                                           "resume.prm",
                                           "--quiet",
                                           option.c_str()};
    for (const std::string &entry : entries)
      {
        arguments.push_back("--set");
        arguments.push_back(entry.c_str());
      }
    std::ostringstream    errors;
    std::streambuf *const buffer = std::cerr.rdbuf(errors.rdbuf());
    const int status = run_program(arguments.size(), arguments.data());
    std::cerr.rdbuf(buffer);
    return {status, errors.str()};
  }



  /// What a clock says, what would be zero without rounding, and numbers of
  /// iterations.
  const std::set<std::string> not_compared = {"wall_seconds",
                                              "memory_mb",
                                              "residual",
                                              "force_balance_error",
                                              "max_penetration",
                                              "edge_penetration",
                                              "max_hanging_penetration",
                                              "complementarity_error",
                                              "newton_iterations",
                                              "linear_iterations"};



  double
  difference(const std::vector<Row> &a, const std::vector<Row> &b)
  {
    if (a.size() != b.size() || a.empty())
      return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (const auto &[column, value] : a.front())
      if (not_compared.count(column) == 0)
        {
          double scale = 1e-300, deviation = 0;
          for (unsigned int i = 0; i < a.size(); ++i)
            {
              if (std::isnan(a[i].at(column)) != std::isnan(b[i].at(column)))
                return std::numeric_limits<double>::infinity();
              scale     = std::max(scale, std::abs(a[i].at(column)));
              deviation = std::max(deviation,
                                   std::abs(a[i].at(column) - b[i].at(column)));
            }
          largest = std::max(largest, deviation / scale);
        }
    return largest;
  }



  const std::vector<std::string> tables = {"history",
                                           "statistics",
                                           "reactions",
                                           "probes",
                                           "surface_profile",
                                           "mesh_changes"};

  fs::path
  file(const std::string &table)
  {
    return "results/" + table + ".csv";
  }



  /// (Estimated errors are computed in single precision.)
  void
  check_same_results(const Entries &entries,
                     const Entries &entries_of_first_part = first_part)
  {
    for (const std::string &entry : entries)
      output() << entry << std::endl;
    verify("  the run", run("--overwrite", entries).first == 0);
    std::map<std::string, std::vector<Row>> straight;
    for (const std::string &table : tables)
      straight[table] = read_table(file(table));
    output() << "  mesh changes: " << straight["mesh_changes"].size()
             << std::endl;
    verify("  its first part",
           run("--overwrite", both(entries, entries_of_first_part)).first == 0);
    verify("  the resumed run", run("--resume", entries).first == 0);
    for (const std::string &table : tables)
      verify("  " + table,
             difference(straight[table], read_table(file(table))),
             1e-6);

    verify("  resumed at its end", run("--resume", entries).first == 0);
    for (const std::string &table : tables)
      verify("  " + table,
             difference(straight[table], read_table(file(table))),
             1e-6);
  }



  /// The size of all tables but one.
  std::uintmax_t
  size_of_others(const std::string &table)
  {
    std::uintmax_t size = 0;
    for (const std::string &other : tables)
      if (other != table)
        size += fs::file_size(file(other));
    return size;
  }



  void
  report_resume(const std::string &situation, const Entries &entries)
  {
    const auto [status, message] = run("--resume", entries);
    output() << "  " << situation << ": exit status " << status << std::endl
             << "  " << message;
  }



  void
  check_refusals(const std::string &entry)
  {
    for (const std::string &table : tables)
      {
        output() << table << std::endl;
        const fs::path name = file(table), saved = "saved.csv";
        const auto     with_damage = [&](const std::string &damage,
                                     const auto        &task) {
          on_first_rank([&]() {
            fs::rename(name, saved);
            task();
          });
          const auto size = size_of_others(table);
          report_resume(damage, {entry});
          verify("  the other tables are as they were",
                 size_of_others(table) == size);
          on_first_rank([&]() { fs::rename(saved, name); });
        };
        const auto without_end_of_first_row = [&]() {
          std::ifstream original(saved);
          std::string   header, row;
          std::getline(original, header);
          std::getline(original, row);
          return header + '\n' + row.substr(0, row.size() / 2);
        };
        with_damage("deleted", []() {});
        with_damage("cut", [&]() {
          std::ofstream(name) << without_end_of_first_row();
        });
        with_damage("zeroed", [&]() {
          std::ofstream(name) << std::string(fs::file_size(saved), '\0');
        });
      }
    report_resume("put back", {entry});
  }



  /// Up to the step that fails, nothing is lost; what has kept it from
  /// converging may change.
  void
  check_failed_step(const std::string &entry)
  {
    output() << "a step that fails" << std::endl;
    const Entries hard  = {entry,
                           "Loading/History=1: depth 0.03 | 2: depth 0.1",
                           "Loading/Number of steps=4",
                           "Refinement/Number of cycles=1",
                           "Nonlinear solver/Maximum number of iterations=6"};
    const Entries uncut = both(hard, {"Loading/Maximum number of cuts=0"});
    verify("  the run", run("--overwrite", hard).first == 0);
    const auto straight = read_table(file("history"));
    verify("  without cuts it fails", run("--overwrite", uncut).first == 3);
    verify("  resumed with cuts", run("--resume", hard).first == 0);
    verify("  history",
           difference(straight, read_table(file("history"))),
           1e-6);
  }



  void
  check_other_control(const std::string &entry)
  {
    output() << "another step control, another evaluation" << std::endl;
    const Entries adaptive = {entry, "Loading/Step control=adaptive"};
    verify("  its first part",
           run("--overwrite", both(adaptive, first_part)).first == 0);
    const std::size_t n_before = read_table(file("history")).size();
    verify("  the resumed run",
           run("--resume", {entry, "Evaluation/Beta=1.03"}).first == 0);
    const auto history = read_table(file("history"));
    output() << "  steps after the checkpoint: " << history.size() - n_before
             << ", the last ends at " << history.back().at("time") << std::endl;
  }



  void
  check_other_histories(const std::string &entry)
  {
    output() << "other histories" << std::endl;
    const auto report = [&](const std::string &situation,
                            const Entries     &other) {
      report_resume(situation, both({entry}, other));
    };
    report("less depth",
           {"Loading/History=1: depth 0.02 | 2: force 10 | 3: depth 0.04"});
    report("another control",
           {"Loading/History=1: depth 0.03 | 2: depth 0.02 | 3: depth 0.04"});
    report("more steps", {"Loading/Number of steps=9"});
    report("another integration", {"Loading/Integration=BDF2"});
    report("shorter", first_part);
    report("another time",
           {"Loading/History=1: depth 0.03 | 2.5: force 10 | 3: depth 0.04"});
  }
} // namespace



int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  on_first_rank([]() { std::ofstream("resume.prm") << input; });
  // (Nothing enters or leaves while the indenter rests.)
  check_same_results(
    {"Refinement/Steps between adaptations=2",
     "Loading/History=1: depth 0.03 | 2: depth 0.03 | 3: depth 0.04"},
    {"Loading/History=1: depth 0.03 | 2: depth 0.03",
     "Loading/Number of steps=4"});
  check_same_results({"Refinement/Steps between adaptations=2",
                      "Loading/Step control=adaptive"});
  check_same_results(
    {"Refinement/Steps between adaptations=2", "Loading/Integration=BDF2"});
  check_same_results({"Refinement/Steps between adaptations=4"});
  check_same_results({"Refinement/Steps between adaptations=2"});
  check_refusals("Refinement/Steps between adaptations=2");
  check_other_histories("Refinement/Steps between adaptations=2");
  check_failed_step("Refinement/Steps between adaptations=0");
  check_other_control("Refinement/Steps between adaptations=0");
}
