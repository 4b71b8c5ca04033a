// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

#include "base/exceptions.h"
#include "output/checked_write.h"

#include <fcntl.h>
#include <unistd.h>

namespace ElastoPlastic
{
  using namespace dealii;

  namespace
  {
    /// What keeps the file @p name from being written, in a sentence.
    std::string
    likely_reason(const std::string &name)
    {
      const auto      folder = std::filesystem::path(name).parent_path();
      std::error_code ignored;
      if (!folder.empty() && !std::filesystem::exists(folder, ignored))
        return "Its folder is not there: has it been removed or renamed "
               "meanwhile?";
      return "Is the disk full, or is writing not allowed there?";
    }



    bool
    is_written(const std::string                         &name,
               const std::function<void(std::ostream &)> &write)
    {
      std::ofstream file(name);
      try
        {
          write(file);
          file.close();
        }
      catch (const StandardExceptions::ExcIO &)
        {
          file.setstate(std::ios::failbit); // deal.II noticed first
        }
      return bool(file);
    }
  } // namespace



  // (What has no place on a disk, like a pipe, says that it is invalid.)
  bool
  write_to_disk(const std::string &name)
  {
    const int file = open(name.c_str(), O_RDONLY);
    if (file < 0)
      return false;
    const bool success = fsync(file) == 0 || errno == EINVAL;
    close(file);
    return success;
  }



  void
  check_written(const MPI_Comm     communicator,
                const std::string &name,
                const bool         success)
  {
    // the lowest rank that failed reports the name of its file
    const unsigned int rank   = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int nobody = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int failed =
      Utilities::MPI::min(success ? nobody : rank, communicator);
    if (failed != nobody)
      throw FileError(
        "The file '" + Utilities::MPI::broadcast(communicator, name, failed) +
        "' could not be written completely. " +
        Utilities::MPI::broadcast(communicator, likely_reason(name), failed));
  }



  void
  checked_write(const MPI_Comm                             communicator,
                const std::string                         &name,
                const std::function<void(std::ostream &)> &write)
  {
    check_written(communicator, name, name.empty() || is_written(name, write));
  }



  void
  checked_write_to_disk(const MPI_Comm                             communicator,
                        const std::string                         &name,
                        const std::function<void(std::ostream &)> &write)
  {
    check_written(communicator,
                  name,
                  name.empty() ||
                    (is_written(name, write) && write_to_disk(name)));
  }
} // namespace ElastoPlastic
