// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Entries that are set in vain: for each entry that there is, it is known when
// it has an effect; each condition holds and fails; and what looks like two
// systems of units in one file.

#include <deal.II/base/mpi.h>

#include <fstream>

#include "input/entry_effects.h"
#include "input/parameter_input.h"
#include "input/parameters.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// The values of all entries of an empty file.
  EntryValues
  default_values()
  {
    std::ofstream("empty.prm") << "";
    CommandLine command_line;
    command_line.parameter_file = "empty.prm";
    return Parameters::read(command_line).entries;
  }



  /// These, read once, with some changes.
  EntryValues
  with_changes(const EntryValues &changes)
  {
    static const EntryValues defaults = default_values();
    EntryValues              values   = defaults;
    for (const auto &[path, value] : changes)
      values.at(path) = value;
    return values;
  }



  /// Whether the entry has an effect without the changes and none with them,
  /// or the other way round.
  void
  compare(const std::string &path, const EntryValues &changes)
  {
    const std::string before = why_without_effect(path, with_changes({})),
                      after  = why_without_effect(path, with_changes(changes));
    verify(path + " without effect: " + before + after,
           before.empty() != after.empty());
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  bool all_known = true;
  for (const auto &[path, value] : with_changes({}))
    if (!effect_is_known(path))
      {
        all_known = false;
        output() << path << ": unknown" << std::endl;
      }
  verify("known for all entries", all_known);

  const EntryValues history    = {{"Loading/History", "1: depth 1"}};
  const EntryValues limit_load = {{"Analysis", "limit load"}};
  const EntryValues none       = {{"Indenter/Type", "none"}};
  for (const char *path : {"Control", "Depth", "Final time"})
    compare("Loading/" + std::string(path), history);
  compare("Loading/Force", {{"Loading/Control", "force"}});
  compare("Loading/Depth", {{"Loading/Control", "force"}});
  compare("Loading/Depth", none);
  compare("Loading/Number of steps", limit_load);
  compare("Loading/Step control", history);
  compare("Loading/Integration", history);
  compare("Kinematics", {{"Dimension", "2"}});
  compare("Geometry/Upper corner", {{"Geometry/Type", "sector"}});
  compare("Geometry/Core radius", {{"Geometry/Type", "sector"}});
  compare("Geometry/Local radius", {{"Geometry/Local refinements", "2"}});
  compare("Geometry/Circle centre", {{"Geometry/Circle radius", "0.5"}});
  compare("Material/Yield stress", {{"Material/Law", "linear elastic"}});
  compare("Material/Yield stress",
          {{"Material/Yield criterion", "Mohr-Coulomb"}});
  compare("Material/Cohesion", {{"Material/Yield criterion", "Mohr-Coulomb"}});
  compare("Material/Yield stress",
          {{"Material/Yield criterion", "Drucker-Prager"}});
  compare("Material/Friction angle",
          {{"Material/Yield criterion", "Drucker-Prager"}});
  compare("Initial stress/Stress xz", {{"Dimension", "2"}});
  compare("Material/Voce rate",
          {{"Material/Law", "linear elastic, nonlinear hardening"},
           {"Material/Voce stress", "0, 100"}});
  compare("Material/Recovery rates",
          {{"Material/Law", "nonlinear hardening"},
           {"Material/Back stress moduli", "2000"}});
  compare("Material/Rate stress", {{"Material/Rate law", "Norton"}});
  compare("Material/Hosford exponent",
          {{"Material/Yield criterion", "Hosford"}});
  compare("Material/Axes", {{"Material/Yield criterion", "Hill"}});
  compare("Loading/Step tolerance", {{"Loading/Step control", "accurate"}});
  compare("Indenter/Radius", {{"Indenter/Type", "cone"}});
  compare("Indenter/Semi-apex angle", {{"Indenter/Type", "spheroconical tip"}});
  compare("Indenter/Position", none);
  compare("Indenter/Surface", limit_load);
  compare("Contact/Edge", history);
  compare("Limit load/Stresses", limit_load);
  compare("Discretization/Polynomial degree", limit_load);
  compare("Refinement/Number of cycles", {{"Refinement/Strategy", "none"}});
  compare("Refinement/Goal",
          {{"Analysis", "contact with error bound"},
           {"Refinement/Strategy", "adaptive"}});
  compare("Refinement/Refinement fraction",
          {{"Refinement/Strategy", "global"}});
  compare("Refinement/Passes", limit_load);
  compare("Linear solver/Maximum number of iterations",
          {{"Linear solver/Type", "direct"}});
  compare("Evaluation/Beta", history);
  compare("Evaluation/Continuous stiffness", history);
  compare("Output/Field times", {{"Output/Fields", "at times"}});
  compare("Output/Additional fields", {{"Output/Fields", "never"}});
  compare("Output/Additional fields", limit_load);

  std::ofstream("included.prm") << "subsection Loading\n set Depth = 1\nend\n";
  std::ofstream("including.prm") << "include included.prm\nset Dimension = 2\n";
  const auto set = entries_set_in("including.prm", with_changes({}));
  verify("entries of a file and those that it includes",
         set == std::set<std::string>{"Dimension", "Loading/Depth"});
  for (const std::string &sentence :
       entries_without_effect(set, with_changes(none)))
    output() << sentence << std::endl;

  std::ofstream("changing.prm")
    << "subsection Indenter\n set Type = none\nend\n"
    << "subsection Loading\n set Depth = 2\nend\n";
  CommandLine command_line;
  command_line.parameter_file = "changing.prm";
  std::ofstream("written.prm")
    << Parameters::read(command_line).effective_input;
  command_line.parameter_file = "written.prm";
  const Parameters written    = Parameters::read(command_line);
  verify("the program writes all entries",
         entries_set_in("written.prm", written.entries).size() ==
           written.entries.size());
  verify("those that it was told",
         written.entries_changed_in("written.prm") ==
           std::set<std::string>{"Indenter/Type", "Loading/Depth"});

  verify("units of the defaults", doubtful_units(with_changes({})).empty());
  for (const EntryValues &changes :
       {EntryValues{{"Material/Yield stress", "0.4"}},
        EntryValues{{"Material/Young's modulus", "200"}},
        EntryValues{{"Material/Law", "linear elastic, kinematic hardening"},
                    {"Material/Kinematic hardening modulus", "0, 300000"}},
        EntryValues{{"Material/Law", "isotropic hardening"},
                    {"Material/Isotropic hardening modulus", "0, 300000"}}})
    for (const std::string &sentence : doubtful_units(with_changes(changes)))
      output() << sentence << std::endl;
}
