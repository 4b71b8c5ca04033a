// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What has been solved is not lost when what comes after it fails: the error
// bound on the last mesh, or the equilibrium on a mesh that has been adapted.

#include <cmath>
#include <iostream>

#include "app/program.h"
#include "table.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// Runs a punch on a perfectly plastic body, without its messages. @return
  /// the exit status.
  int
  press(const std::vector<std::string> &entries)
  {
    std::vector<const char *> arguments = {"elasto_plastic_contact",
                                           SOURCE_DIR
                                           "/../parameter_files/verification/"
                                           "strip_punch.prm",
                                           "--quiet",
                                           "--overwrite",
                                           "--output-directory",
                                           "results"};
    for (const std::string &entry : entries)
      {
        arguments.push_back("--set");
        arguments.push_back(entry.c_str());
      }
    std::streambuf *const messages = std::cerr.rdbuf(nullptr);
    const int status = run_program(arguments.size(), arguments.data());
    std::cerr.rdbuf(messages);
    return status;
  }



  // The exact limit of this force is 2.97: a mesh of ten by ten cells has no
  // admissible stresses.
  void
  check_missing_bound()
  {
    output() << "no bound on the last mesh" << std::endl;
    output() << "  exit status "
             << press({"Analysis=contact with error bound",
                       "Geometry/Initial refinements=0",
                       "Loading/Control=force",
                       "Loading/Force=2.75",
                       "Refinement/Number of cycles=1"})
             << std::endl;
    const auto history    = read_table("results/history.csv");
    const auto statistics = read_table("results/statistics.csv");
    verify("  one step", history.size() == 1);
    verify("  one solve", statistics.size() == 1);
    if (history.empty())
      return;
    verify("  its force", std::abs(history[0].at("force") - 2.75), 1e-7);
    verify("  without bound", std::isinf(history[0].at("estimated_error")));
    verify("  fields", !!std::ifstream("results/solution-000.pvtu"));
  }



  // The exact limit of this force is 10.3, under a circular punch: the first
  // mesh bears more, the next one does not. (With tractions, be they zero, no
  // bound of it is asked for.)
  void
  check_adapted_mesh()
  {
    output() << "no equilibrium on the adapted mesh" << std::endl;
    output() << "  exit status "
             << press({"Kinematics=axisymmetric",
                       "Geometry/Initial refinements=2",
                       "Boundary conditions/Free=",
                       "Boundary conditions/Traction=right: 0; 0",
                       "Loading/History=1: force 10.5 | 2: force 0",
                       "Loading/Number of steps=10",
                       "Refinement/Number of cycles=1",
                       "Refinement/Steps between adaptations=5",
                       "Refinement/Refinement fraction=0.1",
                       "Output/Fields=never"})
             << std::endl;
    const auto history = read_table("results/history.csv");
    verify("  ten steps", history.size() == 10);
    if (history.size() != 10)
      return;
    verify("  the largest force",
           std::abs(history[4].at("force") - 10.5),
           1e-7);
    verify("  a finer mesh", history[5].at("cells") > history[4].at("cells"));
    verify("  the next force", std::abs(history[5].at("force") - 8.4), 1e-7);
    const auto &last = history.back();
    verify("  energy is not lost",
           std::abs(last.at("external_work") - last.at("elastic_energy") -
                    last.at("dissipation")) /
             last.at("external_work"),
           0.1);
    verify("  no row of mesh_changes.csv",
           read_table("results/mesh_changes.csv").empty());
  }
} // namespace



int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_missing_bound();
  check_adapted_mesh();
}
