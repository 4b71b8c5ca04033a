// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What the command line means, and what is said about wrong usage.

#include "input/command_line.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  CommandLine
  parse(const std::vector<std::string> &arguments)
  {
    std::vector<const char *> argv = {"elasto_plastic_contact"};
    for (const std::string &argument : arguments)
      argv.push_back(argument.c_str());
    return CommandLine::parse(argv.size(), argv.data());
  }



  std::string
  name_of(const CommandLine::Task task)
  {
    using Task = CommandLine::Task;
    switch (task)
      {
        case Task::run:
          return "run";
        case Task::validate:
          return "validate";
        case Task::print_parameters:
          return "print parameters";
        case Task::list_cases:
          return "list cases";
        case Task::print_help:
          return "print help";
        case Task::print_version:
          return "print version";
      }
    return "";
  }



  void
  print(const std::vector<std::string> &arguments)
  {
    std::string title;
    for (const std::string &argument : arguments)
      title += '[' + argument + ']';
    print_error(title, [&] {
      const CommandLine line = parse(arguments);
      output() << "  task: " << name_of(line.task)
               << "; file: " << line.parameter_file
               << "; directory: " << line.output_directory
               << "; overwrite: " << line.overwrite << "; quiet: " << line.quiet
               << '\n';
      for (const auto &[path, value] : line.overrides)
        output() << "    '" << path << "' becomes '" << value << "'\n";
    });
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  print({"case.prm"});
  print({"case.prm", "--validate", "--quiet"});
  print({"--output-directory", "results", "--overwrite", "case.prm"});
  print({"case.prm", "--output-directory=results"});
  print({"case.prm",
         "--set",
         "Material/Yield stress=300",
         "--set",
         "Boundary conditions/Traction=top: if(x==0, 1, 2); 0",
         "--set=Dimension="});
  print({"--help"});
  print({"--version", "case.prm"});
  print({"--print-parameters"});
  print({"--list-cases"});
  print({"--list-cases", "case.prm", "--quiet"});

  print({});
  print({"--validate"});
  print({"one.prm", "two.prm"});
  print({"case.prm", "--no-such-option"});
  print({"case.prm", "--output-directory"});
  print({"case.prm", "--output-directory", ""});
  print({"case.prm", "--set"});
  print({"case.prm", "--set", "Dimension"});
  print({"case.prm", "--set", "=3"});
  print({"case.prm", "--overwrite=yes"});

  verify("help names the exit status",
         CommandLine::help().find("Exit status") != std::string::npos);
}
