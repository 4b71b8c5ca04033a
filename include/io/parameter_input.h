// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_parameter_input_h
#define io_parameter_input_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Reads a parameter file into @p prm. deal.II reads it; what it has to say
  /// against the file is said in our own words.
  /// @throws InputError with file, line, section, entry, value and what is
  /// allowed.
  void
  read_parameter_file(ParameterHandler &prm, const std::string &file);

  /// Sets the entry @p path, for instance "Geometry/Type".
  /// @throws InputError if there is no such entry or it cannot have this value.
  void
  set_entry(ParameterHandler  &prm,
            const std::string &path,
            const std::string &value);
} // namespace ElastoPlastic

#endif
