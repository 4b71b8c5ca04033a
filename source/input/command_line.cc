// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/program_options.hpp>

#include <sstream>

#include "base/exceptions.h"
#include "input/command_line.h"

namespace ElastoPlastic
{
  namespace
  {
    namespace options = boost::program_options;

    options::options_description
    visible_options()
    {
      options::options_description description("Options");
      // clang-format off
      description.add_options()
        ("set", options::value<std::vector<std::string>>()->value_name("'Section/Entry=value'"),
         "override an entry of the file; repeatable")
        ("output-directory", options::value<std::string>()->value_name("DIR"),
         "where the results go, instead of 'Output/Directory'")
        ("resume", "go on from the last checkpoint in the output directory")
        ("overwrite", "replace the results in the output directory")
        ("validate", "check the input, say what the job will be")
        ("print-parameters", "print every entry with default, range, unit and meaning")
        ("list-cases", "print the names of the ready cases, and what they are")
        ("quiet", "print nothing but errors and warnings")
        ("version", "print the version")
        ("help", "print this text");
      // clang-format on
      return description;
    }



    std::pair<std::string, std::string>
    split_override(const std::string &text)
    {
      const auto equal_sign = text.find('=');
      if (equal_sign == std::string::npos || equal_sign == 0)
        throw InputError("The option --set '" + text +
                         "' does not have the form "
                         "--set 'Section/Entry=value'.");
      return {text.substr(0, equal_sign), text.substr(equal_sign + 1)};
    }



    CommandLine::Task
    chosen_task(const options::variables_map &given)
    {
      using Task = CommandLine::Task;
      if (given.count("help"))
        return Task::print_help;
      if (given.count("version"))
        return Task::print_version;
      if (given.count("print-parameters"))
        return Task::print_parameters;
      if (given.count("list-cases"))
        return Task::list_cases;
      return given.count("validate") ? Task::validate : Task::run;
    }
  } // namespace



  std::string
  CommandLine::help()
  {
    std::ostringstream text;
    text
      << "Usage: elasto_plastic_contact FILE.prm [options]\n"
      << "Presses a rigid indenter into an elasto-plastic body. FILE.prm is a "
         "file,\nor else the name of a ready case.\n\n"
      << visible_options()
      << "\nExit status: 0 done; 2 wrong usage or input; 3 no convergence; "
         "4 no\nequilibrium exists; 5 input or output failed; 143 ended by the signal "
         "SIGTERM.\n";
    return text.str();
  }



  CommandLine
  CommandLine::parse(const int argc, const char *const *const argv)
  {
    options::options_description all_options;
    all_options.add(visible_options())
      .add_options()("file", options::value<std::vector<std::string>>());
    options::positional_options_description positional;
    positional.add("file", -1);

    options::variables_map given;
    try
      {
        options::store(options::command_line_parser(argc, argv)
                         .options(all_options)
                         .positional(positional)
                         .run(),
                       given);
      }
    catch (const options::error &error)
      {
        throw InputError("Wrong usage: " + std::string(error.what()) +
                         ". See elasto_plastic_contact --help.");
      }

    CommandLine result;
    result.task      = chosen_task(given);
    result.overwrite = given.count("overwrite") > 0;
    result.resume    = given.count("resume") > 0;
    if (result.overwrite && result.resume)
      throw InputError(
        "Wrong usage: --overwrite begins anew, --resume goes on "
        "with what is there. Give one of them only.");
    result.quiet = given.count("quiet") > 0;
    if (given.count("output-directory"))
      {
        result.output_directory = given["output-directory"].as<std::string>();
        if (result.output_directory.empty())
          throw InputError(
            "Wrong usage: --output-directory must name a folder; "
            "'.' is the one that the program runs in.");
      }
    if (given.count("set"))
      for (const std::string &text :
           given["set"].as<std::vector<std::string>>())
        result.overrides.push_back(split_override(text));

    if (result.task == Task::run || result.task == Task::validate)
      {
        const auto n_files =
          given.count("file") ?
            given["file"].as<std::vector<std::string>>().size() :
            0;
        if (n_files != 1)
          throw InputError("Wrong usage: give exactly one parameter file (" +
                           std::to_string(n_files) +
                           " given). See elasto_plastic_contact --help.");
        result.parameter_file =
          given["file"].as<std::vector<std::string>>().front();
      }
    return result;
  }
} // namespace ElastoPlastic
