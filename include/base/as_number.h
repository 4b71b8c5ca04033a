// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_as_number_h
#define base_as_number_h

#include <deal.II/base/utilities.h>

#include <optional>
#include <string>

namespace ElastoPlastic
{
  /// The number that @p text is, if it is one. It may be infinite.
  inline std::optional<double>
  as_number(const std::string &text)
  {
    try
      {
        std::size_t  end   = 0;
        const double value = std::stod(text, &end);
        if (dealii::Utilities::trim(text.substr(end)).empty())
          return value;
      }
    catch (const std::exception &)
      {}
    return {};
  }
} // namespace ElastoPlastic

#endif
