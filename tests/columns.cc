// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The page doc/tables.md, which is the expected output of this test: what the
// columns of the tables mean is said where they are defined.

#include "io/columns.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  template <typename Record>
  void
  print(const std::string     &title,
        const std::string     &rows,
        const Columns<Record> &columns)
  {
    output() << "\n## " << title << "\n\nOne row per " << rows
             << ".\n\n| column | unit | meaning |\n|---|---|---|\n";
    for (const auto &column : columns)
      output() << "| `" << column.name << "` | " << column.unit << " | "
               << column.meaning << " |\n";
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  output()
    << "# Columns of the tables\n\nUnits are those of the input: force, length, "
       "stress = force / length^2. What is per unit thickness in\nplane strain "
       "and plane stress is that of a slice of thickness 1.\n";
  print("history.csv", "converged load step", history_columns());
  print("surface_profile.csv",
        "point of the contact surface, for the steps that `Output/Surface "
        "profile` names",
        surface_profile_columns(3));
  print("statistics.csv",
        "nonlinear solve, that is per mesh",
        statistics_columns());
  print("mesh_changes.csv",
        "change of the mesh between two load steps",
        mesh_change_columns());
  print("indentation.csv", "unloading", indentation_columns());
  print("limit_load.csv", "mesh", limit_load_columns());
  print("error_bound.csv", "mesh", error_bound_columns());
}
