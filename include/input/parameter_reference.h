// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef input_parameter_reference_h
#define input_parameter_reference_h

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>
#include <string>

namespace ElastoPlastic
{
  using namespace dealii;

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
