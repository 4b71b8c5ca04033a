// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>
#include <boost/crc.hpp>
#include <boost/serialization/map.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "base/exceptions.h"
#include "base/version.h"
#include "input/parameter_input.h"
#include "output/checked_write.h"
#include "restart/checkpoint.h"

namespace ElastoPlastic
{
  using namespace dealii;

  namespace
  {
    namespace fs = std::filesystem;

    const std::string program_name = "ElastoPlasticContact ";

    /// To be raised with each change of what a checkpoint consists of.
    constexpr unsigned int format_number = 2;

    /// The first line of the index. What a checkpoint means is only known to
    /// the version that has written it.
    const std::string signature = program_name +
                                  ELASTO_PLASTIC_CONTACT_VERSION + ", format " +
                                  std::to_string(format_number);

    /// What the paths of entries begin with that may change when a run is
    /// resumed. (Of "Loading", what belongs to the past is compared by
    /// check_same_past().)
    const std::array<std::string, 6> free_entries = {
      {"Linear solver/",
       "Nonlinear solver/",
       "Loading/",
       "Evaluation/",
       "Output/",
       "Refinement/Maximum number of unknowns"}};



    const std::string remedy =
      " Begin anew with the option --overwrite instead of --resume.";



    /// A line of the index: name, size and checksum of @p file.
    std::string
    description(const fs::path &file)
    {
      if (!fs::is_regular_file(file))
        return file.filename().string() + " is no file";
      std::ifstream           stream(file, std::ios::binary);
      boost::crc_32_type      checksum;
      std::array<char, 65536> buffer;
      do
        {
          stream.read(buffer.data(), buffer.size());
          checksum.process_bytes(buffer.data(), stream.gcount());
      } while (stream);
      return file.filename().string() + " " +
             std::to_string(fs::file_size(file)) + " " +
             std::to_string(checksum.checksum());
    }



    std::set<std::string>
    describe_files(const fs::path &folder)
    {
      std::set<std::string> descriptions;
      for (const auto &entry : fs::directory_iterator(folder))
        if (entry.path().stem() != "index")
          descriptions.insert(description(entry.path()));
      return descriptions;
    }



    void
    write_index(const fs::path &folder, std::ostream &index)
    {
      index << signature << '\n';
      for (const std::string &file : describe_files(folder))
        index << file << '\n';
    }



    /// @throws InputError if the files in @p folder are not those of its index.
    void
    check_index(const fs::path &folder)
    {
      std::ifstream index(folder / "index");
      std::string   line;
      if (!std::getline(index, line))
        throw InputError("The checkpoint '" + folder.string() +
                         "' is damaged: the list of its files, 'index', is "
                         "missing." +
                         remedy);
      if (line != signature)
        throw InputError("The checkpoint '" + folder.string() +
                         "' has been written by another version of the program "
                         "('" +
                         line + "'; this is '" + signature + "')." + remedy);
      std::set<std::string> listed;
      while (std::getline(index, line))
        listed.insert(line);

      std::vector<std::string> differences;
      const auto               present = describe_files(folder);
      std::set_symmetric_difference(listed.begin(),
                                    listed.end(),
                                    present.begin(),
                                    present.end(),
                                    std::back_inserter(differences));
      if (!differences.empty())
        throw InputError("The checkpoint '" + folder.string() +
                         "' is damaged: the file '" +
                         differences[0].substr(0, differences[0].find(' ')) +
                         "' is not what has been written." + remedy);
    }



    /// The folder with the last complete checkpoint; empty if there is none.
    /// A new one is complete when its index has got its name, which is before
    /// the folder gets its own.
    fs::path
    last_checkpoint(const fs::path &place)
    {
      const fs::path next = place.string() + ".new";
      if (fs::exists(place))
        return place;
      return fs::exists(next / "index") ? next : fs::path();
    }



    /// Renames the complete new checkpoint into its place. The old one is
    /// removed when the new one is on the disk, its name included.
    /// @return false if that is not possible.
    bool
    put_into_place(const fs::path &place)
    {
      const fs::path next = place.string() + ".new";
      const fs::path old  = place.string() + ".old";
      if (!write_to_disk(next))
        return false;
      fs::remove_all(old);
      if (fs::exists(place))
        fs::rename(place, old);
      fs::rename(next, place);
      if (!write_to_disk(place.parent_path()))
        return false;
      fs::remove_all(old);
      return true;
    }
  } // namespace



  // (The index comes last. Version 0.1.0 has had other names of meshes.)
  bool
  is_checkpoint(const std::string &folder)
  {
    if (!fs::is_directory(folder))
      return false;
    static const std::regex names(
      "index(\\.new)?|state|mesh(-[0-9]{4,}|\\.info|_fixed\\.data|_variable\\.data)?");
    for (const auto &entry : fs::directory_iterator(folder))
      if (!entry.is_regular_file() ||
          !std::regex_match(entry.path().filename().string(), names))
        return false;
    std::ifstream index(fs::path(folder) / "index");
    std::string   line;
    std::getline(index, line);
    return line.empty() || line.rfind(program_name, 0) == 0;
  }



  LoadingParameters
  Checkpoint::Contents::loading() const
  {
    LoadingParameters parameters;
    ParameterHandler  prm;
    parameters.add_parameters(prm);
    for (const auto &[path, value] : entries)
      if (path.rfind("Loading/", 0) == 0)
        set_entry(prm, path, value);
    return parameters;
  }



  void
  Checkpoint::save(
    const std::string                              &state,
    const std::function<void(const std::string &)> &save_mesh) const
  {
    const bool first_rank = Utilities::MPI::this_mpi_process(communicator) == 0;
    const std::string folder        = directory + ".new";
    const auto        on_first_rank = [&](const std::function<bool()> &task) {
      bool success = true;
      if (first_rank)
        try
          {
            success = task();
          }
        catch (const fs::filesystem_error &)
          {
            success = false;
          }
      check_written(communicator, folder, success);
    };

    on_first_rank([&]() {
      if (last_checkpoint(directory) == folder && !put_into_place(directory))
        return false;
      fs::remove_all(folder);
      return fs::create_directory(folder);
    });
    save_mesh(folder + "/mesh");
    // (Into a string: an archive would throw if a file cannot grow. Without a
    // header, which a Boost that is older than the writer's would refuse,
    // though it can read what follows; the index says which program has written
    // it.)
    std::ostringstream text;
    boost::archive::text_oarchive(text, boost::archive::no_header)
      << entries << state;
    checked_write_to_disk(communicator,
                          first_rank ? folder + "/state" : "",
                          [&](std::ostream &file) { file << text.str(); });
    checked_write_to_disk(communicator,
                          first_rank ? folder + "/index.new" : "",
                          [&](std::ostream &file) {
                            write_index(folder, file);
                          });
    on_first_rank([&]() {
      fs::rename(folder + "/index.new", folder + "/index");
      return put_into_place(directory);
    });
  }



  Checkpoint::Contents
  Checkpoint::load() const
  {
    Contents    contents;
    std::string folder;
    on_first_rank(communicator, [&]() {
      folder = last_checkpoint(directory).string();
      if (folder.empty())
        throw InputError("There is nothing to resume: '" + directory +
                         "' does not exist. Start the run without --resume; "
                         "load histories write a checkpoint every "
                         "'Output/Minutes between checkpoints', and at their "
                         "end.");
      check_index(folder);
      std::ifstream file(fs::path(folder) / "state");
      try
        {
          boost::archive::text_iarchive archive(file,
                                                boost::archive::no_header);
          archive >> contents.entries >> contents.state;
        }
      catch (const boost::archive::archive_exception &error)
        {
          throw InputError("The checkpoint '" + folder + "' cannot be read (" +
                           error.what() +
                           "): another revision of the program may have "
                           "written it." +
                           remedy);
        }
      check_entries(contents.entries);
    });
    contents.state = Utilities::MPI::broadcast(communicator, contents.state);
    contents.entries =
      Utilities::MPI::broadcast(communicator, contents.entries);
    contents.mesh_file =
      Utilities::MPI::broadcast(communicator, folder) + "/mesh";
    return contents;
  }



  void
  Checkpoint::check_entries(const Entries &saved) const
  {
    for (const auto &[path, value] : entries)
      {
        bool is_free = false;
        for (const std::string &begin : free_entries)
          is_free = is_free || path.compare(0, begin.size(), begin) == 0;
        is_free =
          is_free && path != "Output/Probe points"; // columns of a table
        const auto before = saved.find(path);
        if (!is_free && (before == saved.end() || before->second != value))
          throw InputError(
            path,
            value,
            "the checkpoint in '" + directory + "' is of a run with '" +
              (before == saved.end() ? "" : before->second) +
              "'. A run can only be resumed with the parameters it has been "
              "started with (those of the sections Output, except for its probe "
              "points, Evaluation, Linear solver and Nonlinear solver may change, 'Refinement/Maximum "
              "number of unknowns', and the load history after the "
              "checkpoint).");
      }
  }
} // namespace ElastoPlastic
