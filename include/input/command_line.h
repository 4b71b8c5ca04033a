// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef input_command_line_h
#define input_command_line_h

#include <string>
#include <utility>
#include <vector>

namespace ElastoPlastic
{
  /// What the user has typed after the program's name.
  struct CommandLine
  {
    /// What the program is asked to do.
    enum class Task
    {
      run,
      validate,
      print_parameters,
      list_cases,
      print_help,
      print_version
    };

    Task task = Task::run;
    /// As the user names it, see ReadyCases::file_meant_by().
    std::string parameter_file;
    /// The --set options: "Section/Entry" and value, in their order.
    std::vector<std::pair<std::string, std::string>> overrides;
    /// Empty if the parameter file decides.
    std::string output_directory;
    bool        overwrite = false;
    bool        resume    = false;
    bool        quiet     = false;

    /// @throws InputError for unknown or incomplete options, and if there is
    /// not exactly one parameter file where one is needed.
    static CommandLine
    parse(const int argc, const char *const *const argv);

    static std::string
    help();
  };
} // namespace ElastoPlastic

#endif
