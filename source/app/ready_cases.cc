// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <ostream>

#include "app/ready_cases.h"
#include "base/exceptions.h"
#include "base/text.h"
#include "base/version.h"

namespace ElastoPlastic
{
  namespace
  {
    namespace fs = std::filesystem;

    const std::string suffix = ".prm";



    bool
    ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() &&
             text.compare(text.size() - end.size(), end.size(), end) == 0;
    }



    std::string
    with_suffix(const std::string &name)
    {
      return ends_with(name, suffix) ? name : name + suffix;
    }



    /// Something, if only a folder or what cannot be opened.
    bool
    exists(const fs::path &path)
    {
      std::error_code error;
      return fs::status(path, error).type() != fs::file_type::not_found;
    }



    bool
    is_folder(const fs::path &path)
    {
      std::error_code error;
      return fs::is_directory(path, error);
    }



    fs::path
    first_folder_of(const std::vector<fs::path> &places)
    {
      const auto found = std::find_if(places.begin(), places.end(), is_folder);
      return found == places.end() ? fs::path() : *found;
    }



    std::string
    quoted(const std::vector<std::string> &names, const std::string &separator)
    {
      std::string text;
      for (const std::string &name : names)
        text += (text.empty() ? "'" : separator + "'") + name + "'";
      return text;
    }



    /// What the comment in the first line of a file says, without a full stop.
    std::string
    first_comment(const fs::path &file)
    {
      const std::string mark = "# ";
      std::ifstream     stream(file);
      std::string       line;
      std::getline(stream, line);
      if (line.compare(0, mark.size(), mark) != 0)
        return "";
      if (line.back() == '.')
        line.pop_back();
      return line.substr(mark.size());
    }
  } // namespace



  std::vector<fs::path>
  ReadyCases::places_of_this_program()
  {
    std::vector<fs::path> places;
    std::error_code       error;
    const fs::path        program = fs::read_symlink("/proc/self/exe", error);
    if (!error)
      places.push_back(program.parent_path().parent_path() /
                       "share/elasto_plastic_contact/parameter_files");
    const fs::path of_checkout = ELASTO_PLASTIC_CONTACT_CASES;
    if (!of_checkout.empty())
      places.push_back(of_checkout);
    return places;
  }



  ReadyCases::ReadyCases(const std::vector<fs::path> &places)
    : places(places)
    , folder(first_folder_of(places))
  {}



  std::string
  ReadyCases::file_meant_by(const std::string &name) const
  {
    for (const std::string &file : {name, with_suffix(name)})
      if (exists(file) && !is_folder(file))
        return file;

    const auto cases = candidates(name);
    if (cases.size() == 1)
      return (folder / cases.front()).string();
    if (cases.size() > 1)
      throw InputError("The name '" + name + "' fits several ready cases: " +
                       quoted(cases, ", ") + ". Give one of these.");
    if (exists(name))
      return name;
    const std::string no_file = "There is no parameter file '" +
                                (fs::current_path() / name).string() + "'";
    throw InputError(folder.empty() ?
                       no_file + ". " + why_there_are_none() :
                       no_file + ", and no ready case '" + name + "' in '" +
                         folder.string() + "'." +
                         did_you_mean(with_suffix(name), names()) +
                         " elasto_plastic_contact --list-cases lists the "
                         "ready cases.");
  }



  void
  ReadyCases::print(std::ostream &out) const
  {
    if (folder.empty())
      throw FileError(why_there_are_none());
    const auto  cases = names();
    std::size_t width = 0;
    for (const std::string &name : cases)
      width = std::max(width, name.size());
    for (const std::string &name : cases)
      out << std::left << std::setw(width + 2) << name
          << first_comment(folder / name) << '\n';
  }



  std::vector<std::string>
  ReadyCases::names() const
  {
    std::vector<std::string> names;
    if (!folder.empty())
      for (const auto &entry : fs::recursive_directory_iterator(
             folder, fs::directory_options::skip_permission_denied))
        if (entry.path().extension() == suffix && entry.is_regular_file())
          names.push_back(
            entry.path().lexically_relative(folder).generic_string());
    std::sort(names.begin(), names.end());
    return names;
  }



  // A case in the folder itself may have the name that another one has in a
  // folder of its own.
  std::vector<std::string>
  ReadyCases::candidates(const std::string &name) const
  {
    const std::string        file = with_suffix(name);
    std::vector<std::string> cases;
    for (const std::string &other : names())
      if (other == file)
        return {file};
      else if (ends_with(other, "/" + file))
        cases.push_back(other);
    return cases;
  }



  std::string
  ReadyCases::why_there_are_none() const
  {
    std::vector<std::string> folders;
    for (const fs::path &place : places)
      folders.push_back(place.string());
    return "There are no ready cases: they would be in " +
           quoted(folders, " or in ") +
           ", but there is no such folder. Install the program together with "
           "them, or give the file with its folder.";
  }
} // namespace ElastoPlastic
