// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <ostream>

#include "output/checked_write.h"
#include "output/columns.h"

namespace ElastoPlastic
{
  namespace
  {
    template <typename Record>
    void
    print_columns(const std::string     &file,
                  const std::string     &rows,
                  const Columns<Record> &columns,
                  const Units           &units,
                  std::ostream          &out)
    {
      out << "\n## " << file << "\n\nOne row per " << rows
          << ".\n\n| column | unit | meaning |\n|---|---|---|\n";
      for (const auto &column : columns)
        out << "| `" << column.name << "` | " << units.of(column.unit) << " | "
            << column.meaning << " |\n";
    }
  } // namespace



  void
  print_table_reference(std::ostream &out, const Units &units)
  {
    out << "# Columns of the tables\n\nUnits are those of the input: ";
    if (units.are_named())
      out << "force " << units.of("force") << ", length " << units.of("length")
          << ", stress " << units.of("stress");
    else
      out << "force, length, stress = force / length^2";
    out << ". What is per unit thickness in\nplane strain and plane stress is "
           "that of a slice of thickness 1.\n";
    print_columns(
      "history.csv", "converged load step", history_columns(), units, out);
    print_columns("surface_profile.csv",
                  "point of the contact surface, for the steps that "
                  "`Output/Surface profile` names",
                  surface_profile_columns(3),
                  units,
                  out);
    print_columns("statistics.csv",
                  "nonlinear solve, that is per mesh",
                  statistics_columns(),
                  units,
                  out);
    print_columns("mesh_changes.csv",
                  "change of the mesh between two load steps",
                  mesh_change_columns(),
                  units,
                  out);
    print_columns("indentation.csv",
                  "unloading, and with rate laws per hold and jump of the rate",
                  indentation_columns(),
                  units,
                  out);
    print_columns("continuous_stiffness.csv",
                  "converged load step in contact, with `Evaluation/Continuous "
                  "stiffness`",
                  continuous_stiffness_columns(),
                  units,
                  out);
    print_columns("limit_load.csv", "mesh", limit_load_columns(), units, out);
    print_columns("error_bound.csv", "mesh", error_bound_columns(), units, out);
  }



  void
  write_table_reference(const MPI_Comm          communicator,
                        const OutputParameters &parameters)
  {
    if (!parameters.units.are_named())
      return;
    checked_write(communicator,
                  Utilities::MPI::this_mpi_process(communicator) == 0 ?
                    parameters.directory + "/tables.md" :
                    "",
                  [&](std::ostream &file) {
                    print_table_reference(file, parameters.units);
                  });
  }
} // namespace ElastoPlastic
