// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef input_entry_effects_h
#define input_entry_effects_h

#include <map>
#include <set>
#include <string>
#include <vector>

namespace ElastoPlastic
{
  /// Values of entries by paths like "Material/Law", as Parameters::entries.
  using EntryValues = std::map<std::string, std::string>;

  /// Why the entry @p path has no effect beside the other values, such as
  /// "'Loading/History' takes its place"; empty if it has one. Only what the
  /// entries themselves say is looked at, no mesh.
  std::string
  why_without_effect(const std::string &path, const EntryValues &values);

  /// Whether it has been decided for this entry when it has an effect: so for
  /// all entries that there are, which a test sees to.
  bool
  effect_is_known(const std::string &path);

  /// One sentence for each of the entries @p set that has no effect.
  std::vector<std::string>
  entries_without_effect(const std::set<std::string> &set,
                         const EntryValues           &values);

  /// What looks like two systems of units in one file, one sentence for each:
  /// Young's moduli that are more than 1e5 times a yield stress (no solid is so
  /// soft, but GPa beside MPa look so), and hardening moduli beyond Young's
  /// modulus.
  std::vector<std::string>
  doubtful_units(const EntryValues &values);
} // namespace ElastoPlastic

#endif
