// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_split_h
#define base_split_h

#include <string>
#include <vector>

namespace ElastoPlastic
{
  /// The parts of the value @p text of the entry @p path between separators,
  /// without blanks around them; none of an empty text.
  /// @throws InputError if a part is empty, be it the last: then a separator
  /// is too many, or what belongs beside it has been forgotten.
  std::vector<std::string>
  split(const std::string &path, const std::string &text, const char separator);
} // namespace ElastoPlastic

#endif
