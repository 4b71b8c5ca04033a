// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <sstream>

#include "base/exceptions.h"
#include "base/split.h"

namespace ElastoPlastic
{
  std::vector<std::string>
  split(const std::string &path, const std::string &text, const char separator)
  {
    std::vector<std::string> parts;
    if (dealii::Utilities::trim(text).empty())
      return parts;
    std::istringstream rest(text + separator);
    for (std::string part; std::getline(rest, part, separator);)
      {
        parts.push_back(dealii::Utilities::trim(part));
        if (parts.back().empty())
          throw InputError(path,
                           text,
                           "number " + std::to_string(parts.size()) +
                             " of the parts that '" + separator +
                             "' separates is empty. Is one '" + separator +
                             "' too many, or has something been forgotten?");
      }
    return parts;
  }
} // namespace ElastoPlastic
