// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What is saved is loaded again, wherever the program has been killed
// meanwhile; and what is damaged, of another version or of another problem is
// refused.

#include <boost/crc.hpp>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "output/checked_write.h"
#include "restart/checkpoint.h"
#include "verdict.h"

#include <sys/resource.h>

using namespace ElastoPlastic;
namespace fs = std::filesystem;

namespace
{
  const Checkpoint::Entries sample_entries = {{"Dimension", "2"},
                                              {"Material/Law",
                                               "linear elastic"},
                                              {"Output/Screen", "full"}};

  void
  write(const std::string &name, const std::string &text)
  {
    on_first_rank([&]() { std::ofstream(name) << text; });
  }



  void
  save(const std::string &state)
  {
    Checkpoint(MPI_COMM_WORLD, "results", sample_entries)
      .save(state, [&](const std::string &mesh_file) {
        write(mesh_file, "mesh of " + state);
      });
  }



  /// The state that is found, or the message on all ranks.
  std::string
  load(const Checkpoint::Entries &entries)
  {
    std::string answer;
    try
      {
        const auto contents =
          Checkpoint(MPI_COMM_WORLD, "results", entries).load();
        std::ifstream mesh(contents.mesh_file);
        std::string   text;
        std::getline(mesh, text);
        answer = contents.state + " (" + text + ")";
      }
    catch (const InputError &error)
      {
        answer = error.what();
      }
    for (const std::string &other :
         dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, answer))
      if (other != answer)
        answer = "FAILED, the ranks disagree";
    return answer;
  }



  void
  report(const std::string         &situation,
         const Checkpoint::Entries &entries = sample_entries)
  {
    output() << situation << ": " << load(entries) << std::endl;
  }



  /// As on a disk that is full when only the list of many files is missing.
  void
  save_where_no_index_fits()
  {
    rlimit unlimited;
    getrlimit(RLIMIT_FSIZE, &unlimited);
    const rlimit limited = {200, unlimited.rlim_max};
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limited);
    bool refused = false;
    try
      {
        Checkpoint(MPI_COMM_WORLD, "results", {})
          .save("short", [](const std::string &mesh_file) {
            for (unsigned int i = 1000; i < 1020; ++i)
              write(mesh_file + "-" + std::to_string(i), "");
          });
      }
    catch (const FileError &)
      {
        refused = true;
      }
    setrlimit(RLIMIT_FSIZE, &unlimited);
    verify("no room for the index", refused);
  }



  void
  test_kills()
  {
    report("nothing yet");
    save_where_no_index_fits();
    report("killed while writing the index of the first");
    on_first_rank([]() { fs::create_directory("results/checkpoint.new"); });
    report("killed while writing the first");
    save("step 1");
    report("saved");
    on_first_rank([]() { fs::create_directory("results/checkpoint.new"); });
    write("results/checkpoint.new/mesh", "half a me");
    report("killed while writing the second");
    save("step 2");
    report("saved over that");
    on_first_rank([]() {
      fs::copy("results/checkpoint", "results/checkpoint.old");
      fs::rename("results/checkpoint", "results/checkpoint.new");
    });
    report("killed between the renamings");
    save("step 3");
    report("saved over that");
    verify("nothing else is left",
           !fs::exists("results/checkpoint.new") &&
             !fs::exists("results/checkpoint.old"));
  }



  /// With the checksum that belongs to it.
  void
  write_state(const std::string &text)
  {
    boost::crc_32_type checksum;
    checksum.process_bytes(text.data(), text.size());
    std::ifstream      index("results/checkpoint/index");
    std::ostringstream new_index;
    for (std::string line; std::getline(index, line);)
      if (line.rfind("state ", 0) == 0)
        new_index << "state " << text.size() << ' ' << checksum.checksum()
                  << '\n';
      else
        new_index << line << '\n';
    MPI_Barrier(MPI_COMM_WORLD);
    write("results/checkpoint/index", new_index.str());
    write("results/checkpoint/state", text);
  }



  void
  test_refusals()
  {
    auto entries             = sample_entries;
    entries["Output/Screen"] = "quiet";
    report("other output", entries);
    entries["Material/Law"] = "perfectly plastic";
    report("other material", entries);
    entries                = sample_entries;
    entries["Material/No"] = "1";
    report("new entry", entries);

    write("results/checkpoint/mesh", "mesh of step 4");
    report("damaged");
    on_first_rank([]() { fs::remove("results/checkpoint/mesh"); });
    report("incomplete");
    save("step 5");
    write("results/checkpoint/mesh.more", "");
    report("more than there was");
    on_first_rank([]() { fs::remove("results/checkpoint/mesh.more"); });
    on_first_rank([]() { fs::create_directory("results/checkpoint/notes"); });
    report("a folder in it");
    verify("it is not the program's alone",
           !is_checkpoint("results/checkpoint"));
    on_first_rank([]() { fs::remove("results/checkpoint/notes"); });
    verify("it is the program's alone", is_checkpoint("results/checkpoint"));
    write_state("22 serialization::archive 99 0 0 0\n");
    report("state with the header of an archive");
    write("results/checkpoint/index", "ElastoPlasticContact 0.0.1\n");
    report("other version");
    on_first_rank([]() { fs::remove("results/checkpoint/index"); });
    report("no index");
  }
} // namespace



int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  on_first_rank([]() {
    fs::remove_all("results");
    fs::create_directory("results");
  });
  test_kills();
  test_refusals();
}
