// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Earlier results are replaced by complete new ones or by nothing, wherever a
// run has been stopped, and what the program has not written stays.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "restart/output_directory.h"
#include "verdict.h"

using namespace ElastoPlastic;
namespace fs = std::filesystem;

namespace
{
  const std::string directory = "output_directory_results";

  void
  write(const std::string &name, const std::string &text)
  {
    on_first_rank([&]() {
      const fs::path file = fs::path(directory) / name;
      fs::create_directories(file.parent_path());
      std::ofstream(file) << text;
    });
  }



  /// The text of a file without the comments that its first lines are: they
  /// name the revision of the program.
  std::string
  contents(const fs::path &file)
  {
    std::ifstream      in(file);
    std::ostringstream text;
    for (std::string comment; in.peek() == '#';)
      std::getline(in, comment);
    text << in.rdbuf();
    return text.str();
  }



  /// All files with their contents.
  void
  print_files(const std::string &title)
  {
    on_first_rank([&]() {
      output() << title << ':';
      std::vector<std::string> files;
      for (const auto &entry : fs::recursive_directory_iterator(directory))
        if (entry.is_regular_file())
          {
            std::ostringstream text;
            text << fs::relative(entry.path(), directory).string();
            if (entry.file_size() > 0)
              text << " (" << contents(entry.path()) << ')';
            files.push_back(text.str());
          }
      std::sort(files.begin(), files.end());
      for (const std::string &file : files)
        output() << ' ' << file;
      output() << std::endl;
    });
  }



  /// Another run, up to its first result if @p complete.
  void
  run(const std::string &text, const bool overwrite, const bool complete)
  {
    print_error("Run " + text, [&]() {
      OutputDirectory output_directory(MPI_COMM_WORLD, directory);
      output_directory.begin_run(overwrite, text);
      write("history.csv", text);
      if (complete)
        output_directory.accept_results();
    });
    print_files("Files");
  }



  void
  rename(const std::string &from, const std::string &to)
  {
    on_first_rank([&]() {
      fs::create_directories((fs::path(directory) / to).parent_path());
      fs::rename(fs::path(directory) / from, fs::path(directory) / to);
    });
  }



  void
  test_overwriting()
  {
    run("1", false, true);
    run("2", false, true);
    for (const std::string name : {"error_bound.csv",
                                   "reactions.csv",
                                   "limit_load.pvd",
                                   "equilibrium.pvd",
                                   "equilibrium-000.vtu",
                                   "limit_load-012.vtu",
                                   "slip_lines-012.vtu",
                                   "surface-last.pvtu",
                                   "solution-last.0001.vtu",
                                   "solution-1000.0000.vtu"})
      write(name, "");
    write("checkpoint/index", "ElastoPlasticContact 0.1.0\n");
    write("checkpoint/state", "");
    write("checkpoint/mesh-0000", "");
    run("3, which fails", true, false);
    write("solution-of-mine.vtu", "");
    write("history.csv.backup", "");
    run("4", true, true);
  }



  void
  test_kills()
  {
    write(".earlier_results/history.csv", "4");
    write(".earlier_results/parameters.prm", "4");
    write("history.csv", "killed");
    write("statistics.csv", "killed");
    run("5, after a kill before the first result", false, true);

    rename("history.csv", ".earlier_results.moved/history.csv");
    run("6, after a kill while setting aside", false, true);

    write(".earlier_results.obsolete/history.csv", "0");
    run("7, after a kill while removing", true, true);

    write(".earlier_results/history.csv", "7");
    write("history.csv", "killed");
    {
      OutputDirectory output_directory(MPI_COMM_WORLD, directory);
      output_directory.resume_run();
    }
    print_files("Resumed after a kill before the first result");
  }



  void
  test_own_folders()
  {
    write("checkpoint/thesis.tex", "");
    run("8, with a folder that is not of the program", true, true);
    rename("checkpoint/thesis.tex", "thesis.tex");
    write("checkpoint/index", "1 2 3\n");
    run("9, with a folder that is not of the program", true, true);
    on_first_rank([]() { fs::remove_all(directory + "/checkpoint"); });
    write("solution.pvd/mine", "");
    run("10, with a folder that is not of the program", true, true);
    rename("solution.pvd/mine", "mine");
    on_first_rank([]() { fs::remove_all(directory + "/solution.pvd"); });
    write(".earlier_results.moved", "");
    run("11, with a file that is not of the program", true, true);
    on_first_rank([]() {
      fs::remove(directory + "/.earlier_results.moved");
      fs::remove(directory + "/.lock");
    });
    write(".lock/mine", "");
    run("12, with a folder that is not of the program", true, true);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  on_first_rank([]() { fs::remove_all(directory); });
  test_overwriting();
  test_kills();
  test_own_folders();
}
