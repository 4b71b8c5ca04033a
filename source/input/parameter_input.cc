// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "base/exceptions.h"
#include "base/text.h"
#include "input/parameter_input.h"

namespace ElastoPlastic
{
  namespace
  {
    namespace fs = std::filesystem;

    using Sections = std::vector<std::string>;

    const std::string see_reference =
      " All sections and entries are listed by elasto_plastic_contact "
      "--print-parameters.";



    std::string
    path_of(const Sections &sections, const std::string &entry)
    {
      std::string path;
      for (const std::string &section : sections)
        path += section + "/";
      return path + entry;
    }



    std::vector<std::string>
    all_paths(const ParameterHandler &prm)
    {
      std::vector<std::string> paths;
      for (const auto &[path, value] : all_entries(prm))
        paths.push_back(path);
      return paths;
    }



    std::vector<std::string>
    all_sections(const ParameterHandler &prm)
    {
      std::set<std::string> sections;
      for (const std::string &path : all_paths(prm))
        if (const auto slash = path.rfind('/'); slash != std::string::npos)
          sections.insert(path.substr(0, slash));
      return {sections.begin(), sections.end()};
    }



    /// The language of deal.II's parameter files, line by line. deal.II's own
    /// reader follows a file that includes itself until the stack is full, does
    /// not say which of several files is wrong, and takes a brace for the
    /// beginning of a list of variants, which it ignores.
    class ParameterFileReader
    {
    public:
      using SetEntry = std::function<
        void(const Sections &, const std::string &, const std::string &)>;

      /// @p prm knows the sections; what is read goes to @p set_entry.
      ParameterFileReader(const ParameterHandler &prm,
                          const SetEntry         &set_entry,
                          const Warn             &warn)
        : prm(prm)
        , set_entry(set_entry)
        , warn(warn)
      {}

      void
      read_file(const std::string &name)
      {
        std::ifstream file(name, std::ios::binary);
        if (!file || fs::is_directory(name))
          throw InputError("The file '" + name +
                           "' does not exist or cannot be read.");
        const fs::path path = fs::canonical(name);
        for (const OpenFile &other : open_files)
          if (other.path == path)
            throw InputError("The file '" + name +
                             "' is included while it is being read.");
        open_files.push_back({name, path, sections.size(), {}});
        std::istringstream stream(
          plain_text({std::istreambuf_iterator<char>(file), {}},
                     [&name](const std::string &what) {
                       throw InputError(name + ", line 1: The file " + what);
                     }));
        read(stream, name);
        open_files.pop_back();
      }

      /// A backslash at the end of a line joins it with the next.
      void
      read(std::istream &stream, const std::string &name)
      {
        const auto  n_sections = sections.size();
        std::string line, text;
        for (unsigned int number = 1; std::getline(stream, line); ++number)
          {
            text += Utilities::trim(line);
            if (!text.empty() && text.back() == '\\')
              text.pop_back();
            else
              interpret(std::exchange(text, ""),
                        name + ", line " + std::to_string(number));
          }
        interpret(text, name);
        if (sections.size() > n_sections)
          throw InputError(name + ": The section '" + sections.back() +
                           "' is not closed: an 'end' is missing. (" +
                           places.back() + ")");
      }

    private:
      /// A file that is being read, how many sections were open when it was
      /// opened, and where it has set which entries.
      struct OpenFile
      {
        std::string                        name;
        fs::path                           path;
        std::size_t                        n_sections;
        std::map<std::string, std::string> entries;
      };

      void
      interpret(const std::string &line, const std::string &place)
      {
        const std::string text =
          Utilities::trim(line.substr(0, line.find('#')));
        if (text.empty())
          return;
        const auto end = std::min(text.find_first_of(" \t"), text.size());
        const std::string keyword = text.substr(0, end);
        const std::string rest    = Utilities::trim(text.substr(end));
        const auto is = [&](const char *const lower, const char *const upper) {
          return keyword == lower || keyword == upper;
        };
        try
          {
            if (is("set", "SET"))
              set(rest, place);
            else if (is("subsection", "SUBSECTION"))
              enter(rest, place);
            else if (is("end", "END"))
              leave(rest);
            else if (is("include", "INCLUDE"))
              include(rest);
            else
              throw InputError(
                "This is none of 'set Entry = value', 'subsection Name', "
                "'end', 'include FILE', and a comment that begins with '#'.");
          }
        catch (const InputError &error)
          {
            throw InputError(place + ": " + error.what());
          }
      }

      void
      set(const std::string &text, const std::string &place)
      {
        const auto equal_sign = text.find('=');
        if (equal_sign == std::string::npos)
          throw InputError("An entry must look like 'set Entry = value'.");
        const std::string entry = Utilities::trim(text.substr(0, equal_sign));
        set_entry(sections,
                  entry,
                  Utilities::trim(text.substr(equal_sign + 1)));
        if (!open_files.empty())
          note_place(path_of(sections, entry), place);
      }

      /// (What an included file has set, this one may set anew.)
      void
      note_place(const std::string &path, const std::string &place)
      {
        const auto [before, is_first] =
          open_files.back().entries.emplace(path, place);
        if (!is_first)
          warn(place + ": The entry '" + path + "' has been set before (" +
               std::exchange(before->second, place) +
               "). This line counts; remove one of the two.");
      }

      void
      enter(const std::string &name, const std::string &place)
      {
        Sections inner = sections;
        inner.push_back(name);
        if (!prm.subsection_path_exists(inner))
          throw InputError(
            "There is no section '" + path_of(sections, name) + "'." +
            (prm.subsection_path_exists({name}) ?
               " Is the 'end' of the section '" + sections.back() +
                 "' missing? (" + places.back() + ")" :
               did_you_mean(name, all_sections(prm)) + see_reference));
        sections = inner;
        places.push_back(place);
      }

      void
      leave(const std::string &rest)
      {
        if (!rest.empty())
          throw InputError("After 'end' nothing can follow but a comment.");
        if (sections.size() ==
            (open_files.empty() ? 0 : open_files.back().n_sections))
          throw InputError("This 'end' closes no 'subsection'.");
        sections.pop_back();
        places.pop_back();
      }

      void
      include(const std::string &name)
      {
        const fs::path file =
          fs::path(open_files.back().name).parent_path() / name;
        if (!fs::is_regular_file(file))
          throw InputError(
            "The file '" + file.string() +
            "' to be included does not exist or cannot be opened. A relative "
            "name starts in the folder of the file that includes it.");
        read_file(file.string());
      }

      const ParameterHandler &prm;
      const SetEntry          set_entry;
      const Warn              warn;
      Sections                sections;
      /// Where the sections begin, in words.
      std::vector<std::string> places;
      std::vector<OpenFile>    open_files;
    };



    /// What parameters.prm could not say.
    bool
    can_be_written(const std::string &value)
    {
      return value.find('#') == std::string::npos &&
             std::none_of(value.begin(),
                          value.end(),
                          [](const unsigned char c) {
                            return c != '\t' && std::iscntrl(c);
                          }) &&
             (value.empty() || value.back() != '\\');
    }



    std::string
    what_matches(const ParameterHandler::ExcValueDoesNotMatchPattern &exception)
    {
      static const std::string before = "the given pattern <";
      std::ostringstream       stream;
      exception.print_info(stream);
      const std::string text  = stream.str();
      const auto        begin = text.rfind(before) + before.size();
      return allowed_values(text.substr(begin, text.rfind('>') - begin));
    }



    /// @p sections exist.
    void
    set_entry_in(ParameterHandler  &prm,
                 const Sections    &sections,
                 const std::string &entry,
                 const std::string &value)
    {
      const std::string path = path_of(sections, entry);
      if (!can_be_written(value))
        throw InputError(path,
                         value,
                         "a value cannot contain '#' or a control character, "
                         "nor end with a backslash: parameters.prm could not "
                         "be read again. Rename the file or folder.");
      const auto leave = [&]() {
        for (unsigned int i = 0; i < sections.size(); ++i)
          prm.leave_subsection();
      };
      try
        {
          for (const std::string &section : sections)
            prm.enter_subsection(section);
          prm.set(entry, value);
          leave();
        }
      catch (const ParameterHandler::ExcEntryUndeclared &)
        {
          leave();
          throw InputError("There is no entry '" + path + "'." +
                           did_you_mean(path, all_paths(prm)) + see_reference);
        }
      catch (const ParameterHandler::ExcValueDoesNotMatchPattern &exception)
        {
          throw InputError(path,
                           value,
                           "it must be: " + what_matches(exception) + ".");
        }
    }
  } // namespace



  void
  read_parameter_file(ParameterHandler  &prm,
                      const std::string &file,
                      const Warn        &warn)
  {
    ParameterFileReader(
      prm,
      [&prm](const Sections    &sections,
             const std::string &entry,
             const std::string &value) {
        set_entry_in(prm, sections, entry, value);
      },
      warn)
      .read_file(file);
  }



  std::set<std::string>
  entries_set_in(const std::string                        &file,
                 const std::map<std::string, std::string> &known)
  {
    ParameterHandler prm; // (sections are made by entering them)
    for (const auto &entry : known)
      {
        prm.enter_subsection(entry.first.substr(0, entry.first.find('/')));
        prm.leave_subsection();
      }
    std::set<std::string> paths;
    ParameterFileReader(
      prm,
      [&paths](const Sections    &sections,
               const std::string &entry,
               const std::string &) { paths.insert(path_of(sections, entry)); },
      [](const std::string &) {})
      .read_file(file);
    return paths;
  }



  void
  set_entry(ParameterHandler  &prm,
            const std::string &path,
            const std::string &value)
  {
    Sections          sections = Utilities::split_string_list(path, '/');
    const std::string entry    = sections.back();
    sections.pop_back();
    // deal.II creates unknown sections on entering: ask before
    if (std::count(sections.begin(), sections.end(), "") > 0 ||
        !prm.subsection_path_exists(sections))
      throw InputError("There is no section for the entry '" + path + "'." +
                       did_you_mean(path, all_paths(prm)) + see_reference);
    set_entry_in(prm, sections, entry, Utilities::trim(value));
  }



  std::map<std::string, std::string>
  all_entries(const ParameterHandler &prm)
  {
    std::stringstream text;
    prm.print_parameters(text, ParameterHandler::ShortPRM);
    std::map<std::string, std::string> entries;
    ParameterFileReader(
      prm,
      [&entries](const Sections    &sections,
                 const std::string &entry,
                 const std::string &value) {
        entries[path_of(sections, entry)] = value;
      },
      [](const std::string &) {})
      .read(text, "parameters.prm");
    return entries;
  }
} // namespace ElastoPlastic
