// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <vector>

#include "base/exceptions.h"
#include "output/checked_write.h"
#include "output/log.h"
#include "restart/checkpoint.h"
#include "restart/output_directory.h"

namespace ElastoPlastic
{
  using namespace dealii;

  namespace
  {
    namespace fs = std::filesystem;

    /// Where earlier results are; and, while they are on their way there or
    /// back, and while they are removed.
    const std::string aside     = ".earlier_results";
    const std::string moved     = aside + ".moved";
    const std::string obsolete  = aside + ".obsolete";
    const std::string lock_file = ".lock";



    /// Whether a run writes files of this name.
    bool
    is_name_of_result(const std::string &name)
    {
      static const std::regex names(
        "parameters\\.prm|tables\\.md|"
        "(history|statistics|reactions|probes|surface_profile|mesh_changes|indentation|continuous_stiffness|limit_load|error_bound)"
        "\\.csv(\\.new)?|"
        "(solution|surface|limit_load|slip_lines|equilibrium)\\.pvd|"
        "(solution|surface)-([0-9]{3,}|last)(\\.pvtu|\\.[0-9]{4,}\\.vtu)|"
        "(limit_load|slip_lines|equilibrium)-[0-9]{3,}\\.vtu");
      return std::regex_match(name, names);
    }



    bool
    is_name_of_checkpoint(const std::string &name)
    {
      return name == "checkpoint" || name == "checkpoint.new" ||
             name == "checkpoint.old";
    }



    FileError
    stands_in_the_way(const fs::path &path)
    {
      return FileError("'" + path.string() +
                       "' stands in the way of the results: the program has "
                       "not written it, or not all that it holds. Move it "
                       "elsewhere, or choose another 'Output/Directory'.");
    }



    /// @throws FileError if @p directory cannot be a folder, or if something
    /// else in it has the name of the lock or of a folder for earlier results.
    void
    check_place(const fs::path &directory)
    {
      fs::path place = fs::absolute(directory);
      while (!fs::exists(place))
        place = place.parent_path();
      if (!fs::is_directory(place))
        throw stands_in_the_way(place);
      if (const fs::path file = directory / lock_file;
          fs::exists(file) && !fs::is_regular_file(file))
        throw stands_in_the_way(file);
      for (const std::string &name : {aside, moved, obsolete})
        if (const fs::path folder = directory / name;
            fs::exists(folder) && !fs::is_directory(folder))
          throw stands_in_the_way(folder);
    }



    /// The files and folders in @p directory that a run has written, by name.
    /// @throws FileError if there is a folder of the user's own that stands in
    /// the way.
    std::vector<std::string>
    results_in(const fs::path &directory)
    {
      std::vector<std::string> results;
      for (const auto &entry : fs::directory_iterator(directory))
        {
          const std::string name           = entry.path().filename().string();
          const bool        is_checkpoints = is_name_of_checkpoint(name);
          if (!is_checkpoints && !is_name_of_result(name))
            continue;
          if (is_checkpoints ? !is_checkpoint(entry.path().string()) :
                               !entry.is_regular_file())
            throw stands_in_the_way(entry.path());
          results.push_back(name);
        }
      std::sort(results.begin(), results.end());
      return results;
    }



    void
    remove_results(const fs::path &directory)
    {
      for (const std::string &result : results_in(directory))
        fs::remove_all(directory / result);
    }



    void
    set_aside(const fs::path &directory)
    {
      fs::create_directory(directory / moved);
      for (const std::string &result : results_in(directory))
        fs::rename(directory / result, directory / moved / result);
      fs::rename(directory / moved, directory / aside);
    }



    /// Undoes set_aside(), wherever that, a later run or this function itself
    /// has been stopped.
    void
    bring_back(const fs::path &directory)
    {
      fs::remove_all(directory / obsolete);
      if (fs::exists(directory / aside))
        {
          remove_results(directory);
          fs::rename(directory / aside, directory / moved);
        }
      if (!fs::exists(directory / moved))
        return;
      for (const auto &entry : fs::directory_iterator(directory / moved))
        fs::rename(entry.path(), directory / entry.path().filename());
      fs::remove(directory / moved);
    }
  } // namespace



  // (If the disk does not let us, the next run will do it.)
  OutputDirectory::~OutputDirectory()
  {
    if (earlier_results_are_aside &&
        Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          bring_back(name);
        }
      catch (const std::exception &)
        {}
  }



  bool
  OutputDirectory::holds_results() const
  {
    bool found = false;
    on_first_rank([&]() {
      check_place(name);
      found = fs::exists(fs::path(name) / aside) ||
              fs::exists(fs::path(name) / moved) ||
              (fs::is_directory(name) && !results_in(name).empty());
    });
    return Utilities::MPI::broadcast(communicator, found);
  }



  void
  OutputDirectory::begin_run(const bool         overwrite,
                             const std::string &effective_input)
  {
    const auto check_results = [&]() {
      const auto results = results_in(name);
      if (!results.empty() && !overwrite)
        throw InputError("The output directory '" + name +
                         "' holds results already (" + results.front() +
                         "). Choose another 'Output/Directory' or add the "
                         "option --overwrite to replace them" +
                         (fs::exists(fs::path(name) / "checkpoint") ?
                            ", or --resume to go on from their checkpoint." :
                            "."));
      return !results.empty();
    };
    on_first_rank([&]() {
      check_place(name);
      fs::create_directories(name);
      lock();
      bring_back(name);
      earlier_results_are_aside = check_results();
      if (earlier_results_are_aside)
        set_aside(name);
    });
    earlier_results_are_aside =
      Utilities::MPI::broadcast(communicator, earlier_results_are_aside);
    write_input(effective_input);
  }



  void
  OutputDirectory::resume_run()
  {
    on_first_rank([&]() {
      if (!fs::is_directory(name))
        return;
      check_place(name);
      lock();
      bring_back(name);
    });
  }



  void
  OutputDirectory::write_input(const std::string &effective_input) const
  {
    checked_write(
      communicator,
      Utilities::MPI::this_mpi_process(communicator) == 0 ?
        name + "/parameters.prm" :
        "",
      [&](std::ostream &file) {
        file << versions(Utilities::MPI::n_mpi_processes(communicator), "# ")
             << effective_input;
      });
  }



  // The renaming makes it sure that they do not come back in part.
  void
  OutputDirectory::accept_results()
  {
    if (!earlier_results_are_aside)
      return;
    earlier_results_are_aside = false;
    on_first_rank([&]() {
      const fs::path directory = name;
      fs::rename(directory / aside, directory / obsolete);
      fs::remove_all(directory / obsolete);
    });
  }



  void
  OutputDirectory::on_first_rank(const std::function<void()> &task) const
  {
    ElastoPlastic::on_first_rank(communicator, [&]() {
      try
        {
          task();
        }
      catch (const fs::filesystem_error &error)
        {
          throw FileError("The output directory '" + name +
                          "' cannot be used: " + error.code().message() +
                          ". Choose another 'Output/Directory'.");
        }
    });
  }



  void
  OutputDirectory::lock()
  {
    const std::string file = name + "/" + lock_file;
    if (!std::ofstream(file, std::ios::app))
      throw FileError("The output directory '" + name +
                      "' cannot be used: writing is not allowed there. Choose "
                      "another 'Output/Directory'.");
    bool is_free = true;
    try
      {
        file_lock = boost::interprocess::file_lock(file.c_str());
        is_free   = file_lock.try_lock();
      }
    catch (const boost::interprocess::interprocess_exception &)
      {} // this file system knows no locks
    if (!is_free)
      throw FileError("The output directory '" + name +
                      "' is in use by another run of the program. Wait until "
                      "it has ended, or choose another 'Output/Directory'.");
  }
} // namespace ElastoPlastic
