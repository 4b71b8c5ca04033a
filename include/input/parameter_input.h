// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef input_parameter_input_h
#define input_parameter_input_h

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <iosfwd>
#include <map>
#include <set>
#include <string>

namespace ElastoPlastic
{
  using namespace dealii;



  using Warn = std::function<void(const std::string &)>;

  /// Reads a parameter file, and those that it includes, into @p prm. @p warn
  /// is told where a file sets an entry twice.
  /// @throws InputError with file, line, section, entry, value and what is
  /// allowed.
  void
  read_parameter_file(ParameterHandler  &prm,
                      const std::string &file,
                      const Warn        &warn);

  /// The paths of all entries that the file, or one that it includes, sets.
  /// @p known: the entries that there are.
  /// @throws InputError as above.
  std::set<std::string>
  entries_set_in(const std::string                        &file,
                 const std::map<std::string, std::string> &known);

  /// Sets the entry @p path, for instance "Geometry/Type".
  /// @throws InputError if there is no such entry or it cannot have this value,
  /// or if a parameter file could not say the value: whatever @p prm prints can
  /// be read again.
  void
  set_entry(ParameterHandler  &prm,
            const std::string &path,
            const std::string &value);

  /// The values of all entries, by paths like "Geometry/Type".
  std::map<std::string, std::string>
  all_entries(const ParameterHandler &prm);



  /// Writes all entries of @p prm, in the order of their declaration, with
  /// default, allowed values and meaning: a page in Markdown that can also be
  /// read on a terminal. Each entry is headed "Section/Entry", as the option
  /// --set wants it.
  void
  print_parameter_reference(const ParameterHandler &prm, std::ostream &out);

  /// The description that deal.II's patterns give of themselves, in words:
  /// "[Integer range 1...2147483647 (inclusive)]" becomes "integer >= 1".
  /// A description of an unknown form is returned as it is.
  std::string
  allowed_values(const std::string &pattern_description);
} // namespace ElastoPlastic

#endif
