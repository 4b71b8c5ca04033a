// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <vector>

#include "base/exceptions.h"
#include "io/checked_write.h"
#include "io/output_directory.h"

namespace ElastoPlastic
{
  using namespace dealii;

  namespace
  {
    namespace fs = std::filesystem;

    /// The files and folders in @p directory that a run has written.
    std::vector<fs::path>
    results_in(const fs::path &directory)
    {
      const std::regex result_names(
        "parameters\\.prm|"
        "(history|statistics|mesh_changes|reactions|indentation|limit_load)\\.csv(\\.new)?|"
        "checkpoint(\\.new|\\.old)?|"
        "(solution|surface|limit_load)(\\.pvd|-.*\\.p?vtu)");
      std::vector<fs::path> results;
      for (const auto &entry : fs::directory_iterator(directory))
        if (std::regex_match(entry.path().filename().string(), result_names))
          results.push_back(entry.path());
      return results;
    }



    /// @return an empty string, or what is wrong.
    std::string
    prepare(const fs::path &directory, const bool overwrite)
    {
      fs::create_directories(directory);
      const auto results = results_in(directory);
      if (!results.empty() && !overwrite)
        return "The output directory '" + directory.string() +
               "' holds results already (" +
               results.front().filename().string() +
               "). Choose another 'Output/Directory' or add the option "
               "--overwrite to replace them.";
      for (const fs::path &result : results)
        fs::remove_all(result);
      return "";
    }
  } // namespace



  void
  prepare_output_directory(const MPI_Comm     communicator,
                           const std::string &directory,
                           const bool         overwrite,
                           const std::string &effective_input)
  {
    std::string refusal, failure;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        try
          {
            refusal = prepare(directory, overwrite);
            if (refusal.empty())
              {
                const fs::path probe = fs::path(directory) / "parameters.prm";
                if (!std::ofstream(probe))
                  failure = "writing is not allowed there";
              }
          }
        catch (const fs::filesystem_error &error)
          {
            failure = error.code().message();
          }
      }
    refusal = Utilities::MPI::broadcast(communicator, refusal);
    failure = Utilities::MPI::broadcast(communicator, failure);
    if (!refusal.empty())
      throw InputError(refusal);
    if (!failure.empty())
      throw FileError("The output directory '" + directory +
                      "' cannot be used: " + failure +
                      ". Choose another 'Output/Directory'.");
    checked_write(communicator,
                  Utilities::MPI::this_mpi_process(communicator) == 0 ?
                    directory + "/parameters.prm" :
                    "",
                  [&](std::ostream &file) { file << effective_input; });
  }
} // namespace ElastoPlastic
