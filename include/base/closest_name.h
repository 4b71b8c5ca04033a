// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_closest_name_h
#define base_closest_name_h

#include <string>
#include <vector>

namespace ElastoPlastic
{
  /// How many letters have to be inserted, removed or replaced to turn @p a
  /// into @p b; capitals are as good as small letters.
  unsigned int
  edit_distance(const std::string &a, const std::string &b);

  /// Completes a message that there is no @p path, such as "Material/Low": "
  /// Did you mean 'Material/Law'?" with the closest of @p paths. What comes
  /// after the last slash must be similar; the rest decides between several.
  /// Empty if nothing is similar.
  std::string
  did_you_mean(const std::string &path, const std::vector<std::string> &paths);
} // namespace ElastoPlastic

#endif
