// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef app_ready_cases_h
#define app_ready_cases_h

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace ElastoPlastic
{
  /// The parameter files that come with the program, all below one folder, and
  /// the names that a user can give them: "indentation/sphere_3d.prm", the same
  /// without ".prm", or its last part alone.
  class ReadyCases
  {
  public:
    /// Where the program that runs looks for them: where they are installed
    /// with it, then in the checkout that it has been built from (unless it
    /// has been built for a package).
    static std::vector<std::filesystem::path>
    places_of_this_program();

    /// Those in the first of @p places that exists; none if none does.
    explicit ReadyCases(const std::vector<std::filesystem::path> &places);

    /// The parameter file that @p name stands for: this file, or this file with
    /// ".prm" at its end, as seen from the current folder, or else a ready
    /// case, or else the folder of that name. Whether it can be read is not
    /// looked at.
    /// @throws InputError if there is no such file, or several such cases.
    std::string
    file_meant_by(const std::string &name) const;

    /// Writes one line for each case: its name, and what its first line says.
    /// @throws FileError if there is no folder of ready cases.
    void
    print(std::ostream &out) const;

  private:
    /// In the order of the alphabet.
    std::vector<std::string>
    names() const;

    /// Those that @p name can stand for.
    std::vector<std::string>
    candidates(const std::string &name) const;

    std::string
    why_there_are_none() const;

    const std::vector<std::filesystem::path> places;
    /// Empty if there is none.
    const std::filesystem::path folder;
  };
} // namespace ElastoPlastic

#endif
