// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <boost/property_tree/json_parser.hpp>

#include <limits>
#include <regex>
#include <sstream>

#include "input/parameter_input.h"

namespace ElastoPlastic
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    /// The entries of @p prm with everything that deal.II knows about them.
    Tree
    as_tree(const ParameterHandler &prm)
    {
      std::stringstream json;
      prm.print_parameters(json,
                           ParameterHandler::JSON |
                             ParameterHandler::KeepDeclarationOrder);
      Tree tree;
      boost::property_tree::read_json(json, tree);
      return tree;
    }



    bool
    is_entry(const Tree &node)
    {
      return node.count("pattern_description") > 0;
    }



    /// "integer >= 1", "number from 0 to 1"; the ends that stand for infinity
    /// are @p lowest and @p highest.
    std::string
    range_in_words(const std::string &kind,
                   const std::string &lower,
                   const std::string &upper,
                   const std::string &lowest,
                   const std::string &highest)
    {
      if (lower == lowest && upper == highest)
        return kind;
      if (upper == highest)
        return kind + " >= " + lower;
      if (lower == lowest)
        return kind + " <= " + upper;
      return kind + " from " + lower + " to " + upper;
    }



    /// "list (at least 1, each: number)"
    std::string
    list_in_words(const std::string &element,
                  const std::string &min_length,
                  const std::string &max_length)
    {
      std::string length;
      if (min_length != "0")
        length += "at least " + min_length + ", ";
      if (max_length !=
          std::to_string(std::numeric_limits<unsigned int>::max()))
        length += "at most " + max_length + ", ";
      return "list, separated by commas (" + length + "each: " + element + ")";
    }



    /// "`box`, `half ball`, `file`"
    std::string
    choices_in_words(const std::string &choices)
    {
      std::string words;
      for (const std::string &choice :
           Utilities::split_string_list(choices, '|'))
        words += (words.empty() ? "`" : ", `") + choice + "`";
      return words;
    }



    /// @p text with line breaks, and without characters that mean something
    /// else in Markdown.
    std::string
    as_paragraph(const std::string &text)
    {
      const std::string escaped =
        std::regex_replace(text, std::regex("[*\\[\\]]"), "\\$&");
      std::string paragraph;
      for (const std::string &line :
           Utilities::break_text_into_lines(escaped, 78))
        // "1. " at the beginning of a line would be a list
        paragraph +=
          std::regex_replace(line, std::regex("^([0-9]+)\\. "), "$1\\. ") +
          '\n';
      return paragraph;
    }



    void
    print_entry(const std::string &path, const Tree &entry, std::ostream &out)
    {
      const auto default_value = entry.get<std::string>("default_value");
      out << "### " << path << "\n\n"
          << as_paragraph(entry.get<std::string>("documentation")) << '\n'
          << "- Default: "
          << (default_value.empty() ? "empty" : "`" + default_value + "`")
          << '\n'
          << "- Values: "
          << allowed_values(entry.get<std::string>("pattern_description"))
          << "\n\n";
    }



    /// The entries of a section, then its sections.
    void
    print_section(const std::string &path,
                  const Tree        &section,
                  std::ostream      &out)
    {
      for (const auto &[name, entry] : section)
        if (is_entry(entry))
          print_entry(path + name, entry, out);
      for (const auto &[name, subsection] : section)
        if (!is_entry(subsection))
          {
            out << "## " << path << name << "\n\n";
            print_section(path + name + "/", subsection, out);
          }
    }
  } // namespace



  std::string
  allowed_values(const std::string &pattern_description)
  {
    static const std::regex anything("\\[Anything\\]");
    static const std::regex selection("\\[Selection (.*) \\]");
    static const std::regex integer(
      "\\[Integer range (\\S+)\\.\\.\\.(\\S+) \\(inclusive\\)\\]");
    static const std::regex number(
      "\\[Double (\\S+)\\.\\.\\.(\\S+) \\(inclusive\\)\\]");
    static const std::regex list(
      "\\[List of <(.*)> of length (\\d+)\\.\\.\\.(\\d+) \\(inclusive\\)\\]");

    std::smatch found;
    if (std::regex_match(pattern_description, anything))
      return "text";
    if (std::regex_match(pattern_description, found, selection))
      return choices_in_words(found[1]);
    if (std::regex_match(pattern_description, found, integer))
      return range_in_words("integer",
                            found[1],
                            found[2],
                            std::to_string(std::numeric_limits<int>::min()),
                            std::to_string(std::numeric_limits<int>::max()));
    if (std::regex_match(pattern_description, found, number))
      return range_in_words(
        "number", found[1], found[2], "-MAX_DOUBLE", "MAX_DOUBLE");
    if (std::regex_match(pattern_description, found, list))
      return list_in_words(allowed_values(found[1]), found[2], found[3]);
    return pattern_description;
  }



  void
  print_parameter_reference(const ParameterHandler &prm, std::ostream &out)
  {
    out << "# Parameters\n\n"
        << as_paragraph(
             "All entries of a parameter file, as printed by "
             "elasto_plastic_contact --print-parameters. 'Section/Entry' is "
             "written 'subsection Section', 'set Entry = value', 'end' in the "
             "file, and --set 'Section/Entry=value' on the command line. Units "
             "are yours, but consistent: a stress is a force per area.")
        << '\n';
    print_section("", as_tree(prm), out);
  }
} // namespace ElastoPlastic
