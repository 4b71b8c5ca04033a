// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <vector>

#include "base/exceptions.h"
#include "io/parameter_input.h"
#include "io/parameter_reference.h"

namespace ElastoPlastic
{
  namespace
  {
    const std::string see_reference =
      " All sections and entries are listed by elasto_plastic_contact "
      "--print-parameters.";



    /// deal.II's own words on what is wrong, in one line.
    std::string
    reason(const ExceptionBase &exception)
    {
      std::ostringstream text;
      exception.print_info(text);
      return Utilities::trim(
        std::regex_replace(text.str(), std::regex("\\s+"), " "));
    }



    std::string
    must_be(const std::string &pattern_description)
    {
      return "it must be: " + allowed_values(pattern_description) + ".";
    }



    /// The sections that a line of a file lies in, written "Section/".
    std::string
    section_of_line(const std::string &file, const unsigned int line_number)
    {
      std::ifstream            stream(file);
      std::vector<std::string> sections;
      std::string              line;
      for (unsigned int i = 1; i < line_number && std::getline(stream, line);
           ++i)
        {
          std::istringstream words(line.substr(0, line.find('#')));
          std::string        keyword, name;
          words >> keyword;
          std::getline(words, name);
          if (keyword == "subsection" || keyword == "SUBSECTION")
            sections.push_back(Utilities::trim(name) + "/");
          else if ((keyword == "end" || keyword == "END") && !sections.empty())
            sections.pop_back();
        }

      std::string path;
      for (const std::string &section : sections)
        path += section;
      return path;
    }



    /// What is wrong with one line, if deal.II's @p complaint is about the
    /// entries, or else an empty string.
    std::string
    wrong_entry(const std::string &complaint, const std::string &section)
    {
      static const std::regex no_section(
        "There is no such subsection to be entered: (.*)");
      static const std::regex no_entry(
        "No entry with name <(.*)> was declared in the current subsection\\.");
      static const std::regex wrong_value(
        "The entry value (.*) for the entry named (.*) does not match the "
        "given pattern: (.*)");

      std::smatch found;
      if (std::regex_match(complaint, found, no_section))
        return "There is no section '" + found.str(1) + "'." + see_reference;
      if (std::regex_match(complaint, found, no_entry))
        return "There is no entry '" + section + found.str(1) + "'." +
               see_reference;
      if (std::regex_match(complaint, found, wrong_value))
        return InputError(section + found.str(2), found[1], must_be(found[3]))
          .what();
      return "";
    }



    /// The same for mistakes in the way the line is written. Text that deal.II
    /// says in another way is left as it is.
    std::string
    wrong_syntax(const std::string &complaint)
    {
      static const std::vector<std::pair<std::regex, std::string>> own_words = {
        {std::regex("Invalid format of 'set' or 'SET' statement\\."),
         "An entry must look like 'set Entry = value'."},
        {std::regex("Invalid content after 'end' or 'END' statement\\."),
         "After 'end' nothing can follow but a comment."},
        {std::regex("There is no subsection to leave here\\."),
         "This 'end' closes no 'subsection'."},
        {std::regex("This line contains an 'include' .* <(.*)> cannot be "
                    "opened\\."),
         "The file '$1' to be included does not exist or cannot be opened. A "
         "relative name starts in the working directory."},
        {std::regex("The line .* could not be parsed: .*"),
         "This is none of 'set Entry = value', 'subsection Name', 'end', "
         "'include FILE', and a comment that begins with '#'."}};

      for (const auto &[pattern, words] : own_words)
        if (std::regex_match(complaint, pattern))
          return std::regex_replace(complaint, pattern, words);
      return complaint;
    }



    std::string
    in_our_words(const std::string &complaint, const std::string &file)
    {
      static const std::regex about_line(
        "Line <(\\d+)> of file <(.*?)>?: (.*)");
      static const std::regex unbalanced("There are unequal numbers of .*");

      std::smatch found;
      if (std::regex_match(complaint, unbalanced))
        return file +
               ": The number of lines 'subsection' and 'end' is not the "
               "same. Close each section with 'end'.";
      if (!std::regex_match(complaint, found, about_line))
        return file + ": " + complaint;

      const std::string section =
        section_of_line(found[2], std::stoul(found[1]));
      const std::string entry_message = wrong_entry(found[3], section);
      return found.str(2) + ", line " + found.str(1) + ": " +
             (entry_message.empty() ? wrong_syntax(found[3]) : entry_message);
    }



    /// deal.II takes a value with a brace for a list of variants, and leaves
    /// the entry as it was.
    void
    reject_braces(ParameterHandler &prm, const std::string &file)
    {
      std::stringstream text;
      prm.print_parameters(text, ParameterHandler::ShortPRM);
      for (std::string line; std::getline(text, line);)
        if (line.find('{') != std::string::npos)
          throw InputError(file + ": A value cannot contain braces: '" +
                           Utilities::trim(line) + "'.");
    }
  } // namespace



  void
  read_parameter_file(ParameterHandler &prm, const std::string &file)
  {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file))
      throw InputError("The parameter file '" + file +
                       "' does not exist or cannot be read.");
    try
      {
        prm.parse_input(stream, file);
      }
    catch (const ExceptionBase &exception)
      {
        throw InputError(in_our_words(reason(exception), file));
      }
    reject_braces(prm, file);
  }



  void
  set_entry(ParameterHandler  &prm,
            const std::string &path,
            const std::string &value)
  {
    std::vector<std::string> names = Utilities::split_string_list(path, '/');
    const std::string        entry = names.back();
    names.pop_back();
    // deal.II creates unknown sections on entering: ask before
    if (std::count(names.begin(), names.end(), "") > 0 ||
        !prm.subsection_path_exists(names))
      throw InputError("There is no section for the entry '" + path + "'." +
                       see_reference);
    try
      {
        for (const std::string &section : names)
          prm.enter_subsection(section);
        prm.set(entry, Utilities::trim(value));
        for (unsigned int i = 0; i < names.size(); ++i)
          prm.leave_subsection();
      }
    catch (const ParameterHandler::ExcEntryUndeclared &)
      {
        throw InputError("There is no entry '" + path + "'." + see_reference);
      }
    catch (const ParameterHandler::ExcValueDoesNotMatchPattern &exception)
      {
        static const std::regex pattern(".* the given pattern <(.*)>\\.");
        throw InputError(
          path,
          value,
          must_be(std::regex_replace(reason(exception), pattern, "$1")));
      }
  }
} // namespace ElastoPlastic
