// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What the .prm tests run: the program itself, with a results folder of the
// test's own that may be overwritten, and after it a look at the results: what
// must hold after every solve, whatever the case.

#include <deal.II/base/mpi.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "app/program.h"
#include "table.h"

namespace
{
  void
  require(const bool holds, const std::string &what, const Row &row)
  {
    if (!holds)
      std::cout << "FAILED in cycle " << row.at("cycle") << ": " << what
                << std::endl;
  }



  /// In the .vtu file @p name, every array of a piece that has cells has
  /// numbers.
  void
  check_fields(const std::string &name)
  {
    std::ifstream file(name);
    std::string   line;
    std::string   last_line;
    bool          has_cells = false;
    while (std::getline(file, line))
      {
        last_line = line;
        if (line.find("<Piece") != std::string::npos)
          has_cells = line.find("NumberOfCells=\"0\"") == std::string::npos;
        if (line.find("<DataArray") != std::string::npos)
          {
            std::string numbers;
            std::getline(file, numbers);
            if (has_cells && numbers.empty())
              std::cout << "FAILED: empty in " << name << ": " << line
                        << std::endl;
          }
      }
    if (last_line.find("</VTKFile>") == std::string::npos)
      std::cout << "FAILED: " << name << " has no end" << std::endl;
  }



  /// Equilibrium, no penetration, no tension, complementarity.
  void
  check_solve(Row row)
  {
    require(row["residual"] <= 1e-8, "residual", row);
    require(row["force_balance_error"] <= 1e-8, "force balance", row);
    require(row["max_penetration"] <= 1e-10 * row["depth"], "penetration", row);
    require(row["min_pressure"] >= -1e-10 * row["max_pressure"],
            "tension",
            row);
    require(row["complementarity_error"] <= 1e-8, "complementarity", row);
  }



  /// Without tractions, the forces of supports and indenter add up to zero, in
  /// each direction; the vertical one is the last. Forces are small against the
  /// largest one until then.
  void
  check_reactions(const std::vector<Row> &history,
                  const std::vector<Row> &reactions)
  {
    double scale = 0;
    if (history.size() != reactions.size())
      std::cout << "FAILED: reactions.csv has " << reactions.size() << " steps"
                << std::endl;
    for (unsigned int i = 0; i < reactions.size(); ++i)
      {
        std::map<char, double> sums;
        scale = std::max(scale, history.at(i).at("force"));
        for (const auto &[column, value] : reactions[i])
          if (column[column.size() - 2] == '_')
            {
              sums[column.back()] += value;
              scale = std::max(scale, std::abs(value));
            }
        sums.rbegin()->second -= history[i].at("force");
        for (auto axis = sums.begin(); axis != std::prev(sums.end()); ++axis)
          axis->second +=
            history[i].at(std::string("tangential_force_") + axis->first);
        for (const auto &[axis, sum] : sums)
          if (std::abs(sum) > 1e-10 * scale)
            std::cout << "FAILED in step " << i + 1 << ": reactions along "
                      << axis << " leave " << sum / scale << std::endl;
      }
  }



  /// What sticks is a part of the contact.
  void
  check_areas(const std::vector<Row> &history)
  {
    for (const Row &row : history)
      if (row.at("stick_area") > (1. + 1e-12) * row.at("contact_area"))
        std::cout << "FAILED in step " << row.at("step") << ": "
                  << row.at("stick_area") << " of " << row.at("contact_area")
                  << " stick" << std::endl;
  }



  /// They begin where the force is larger than before and after, whatever the
  /// mesh has done there, with the numbers of history.csv.
  void
  check_unloadings(const std::vector<Row> &history,
                   const std::vector<Row> &unloadings)
  {
    for (const Row &unloading : unloadings)
      {
        const auto maximum = history.begin() + unloading.at("step") - 1;
        for (const std::string column : {"depth", "force"})
          if (unloading.at("max_" + column) != maximum->at(column))
            std::cout << "FAILED: an unloading from the " << column << " "
                      << unloading.at("max_" + column) << std::endl;
        for (const auto neighbour : {maximum - 1, maximum + 1})
          if (neighbour->at("force") > maximum->at("force"))
            std::cout << "FAILED: an unloading from " << maximum->at("force")
                      << ", which is not the largest force" << std::endl;
      }
    if (!unloadings.empty())
      std::cout << unloadings.size() << " unloadings checked" << std::endl;
  }
} // namespace



int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const char *const                              arguments[] = {
                                 argv[0], argv[1], "--overwrite", "--output-directory", "results"};
  const int status = ElastoPlastic::run_program(5, arguments);
  if (status == 0 &&
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      const auto rows = read_table("results/statistics.csv");
      for (const Row &row : rows)
        check_solve(row);
      const auto history = read_table("results/history.csv");
      check_reactions(history, read_table("results/reactions.csv"));
      check_areas(history);
      check_unloadings(history, read_table("results/indentation.csv"));
      for (const auto &entry : std::filesystem::directory_iterator("results"))
        if (entry.path().extension() == ".vtu")
          check_fields(entry.path());
      std::cout << rows.size() << " solves checked" << std::endl;
    }
  return status;
}
