// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Which file a name stands for: one of the current folder, or a ready case by
// its name, without the end of its name, or by the last part of it.

#include <filesystem>
#include <fstream>

#include "app/ready_cases.h"
#include "verdict.h"

using namespace ElastoPlastic;
namespace fs = std::filesystem;

namespace
{
  const std::string folder = "ready_cases";



  void
  write(const std::string &name, const std::string &text)
  {
    fs::create_directories(fs::absolute(name).parent_path());
    std::ofstream(name) << text;
  }



  void
  write_cases()
  {
    write(folder + "/ball.prm", "# A ball on a block.\nset Dimension = 3\n");
    write(folder + "/indentation/ball.prm", "# A ball, up to e.g. 1 mm\n");
    write(folder + "/indentation/cone.prm", "# A cone.\n# In two lines.\n");
    write(folder + "/friction/plate.prm", "set Dimension = 2\n");
    write(folder + "/friction/long_name_of_a_plate.prm", "");
    write(folder + "/limit_load/plate.prm", "# A plate with a hole...\n");
    write(folder + "/limit_load/plate.msh", "# No case.\n");
    fs::create_directories(folder + "/empty.prm");
  }



  /// Without the current folder, which is another one elsewhere.
  std::string
  without_current_folder(const std::string &message)
  {
    const std::string here = fs::current_path().string();
    std::string       text = message;
    for (auto i = text.find(here); i != std::string::npos; i = text.find(here))
      text.replace(i, here.size(), "HERE");
    return text;
  }



  void
  find(const ReadyCases &cases, const std::string &name)
  {
    output() << "'" << name << "': ";
    try
      {
        output() << cases.file_meant_by(name) << std::endl;
      }
    catch (const Error &error)
      {
        output() << "exit status " << static_cast<int>(error.status) << ": "
                 << without_current_folder(error.what()) << std::endl;
      }
  }



  void
  find_by_name()
  {
    const ReadyCases cases({"no_such_folder", folder, "friction"});
    output() << "A ready case" << std::endl;
    for (const char *const name : {"indentation/cone.prm",
                                   "indentation/cone",
                                   "cone.prm",
                                   "cone",
                                   "ball",
                                   "indentation/ball"})
      find(cases, name);

    output() << "Several, or none" << std::endl;
    for (const char *const name : {"plate",
                                   "plate.prm",
                                   "late",
                                   "cone.msh",
                                   "indentation",
                                   "indentation/kone",
                                   "/no/such/folder/cone.prm",
                                   "../ready_cases/ball.prm",
                                   ""})
      find(cases, name);
  }



  void
  current_folder_comes_first()
  {
    const ReadyCases cases({folder});
    output() << "In the current folder" << std::endl;
    write("cone.prm", "");
    fs::create_directories("friction/plate.prm");
    find(cases, "cone.prm");
    find(cases, "cone");
    find(cases, "./cone");
    find(cases, "indentation/cone");
    find(cases, "friction");
    find(cases, "friction/plate");
    fs::remove("cone.prm");
    fs::remove_all("friction");
  }



  void
  print_list()
  {
    output() << "The list" << std::endl;
    ReadyCases({folder}).print(output());

    const ReadyCases none({"no_such_folder", "ready_cases/ball.prm"});
    print_error("No folder", [&none]() { none.print(output()); });
    find(none, "cone");
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  fs::remove_all(folder);
  write_cases();
  find_by_name();
  current_folder_comes_first();
  print_list();

  const auto places = ReadyCases::places_of_this_program();
  verify("installed beside the program that runs",
         places.front() == fs::canonical(argv[0]).parent_path().parent_path() /
                             "share/elasto_plastic_contact/parameter_files");
}
