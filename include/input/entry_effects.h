// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef input_entry_effects_h
#define input_entry_effects_h

#include <functional>
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



  /// Conditions under which an entry has an effect, of which those of
  /// entry_effects.cc are made. Each is a function of all values that says why
  /// there is none; empty if there is one.
  namespace EntryReasons
  {
    using Names  = std::vector<std::string>;
    using Reason = std::function<std::string(const EntryValues &)>;

    /// The numbers of the list @p path.
    std::vector<double>
    numbers(const EntryValues &values, const std::string &path);

    /// The list @p path has one of @p allowed.
    Reason
    with(const std::string &path, const Names &allowed);

    /// The entry @p path is not @p excluded.
    Reason
    without(const std::string &path, const std::string &excluded);

    /// One of the numbers of the list @p path is not 0.
    Reason
    with_nonzero(const std::string &path);

    /// There is no table in 'Loading/History'.
    Reason
    without_history();

    /// The load is a history: Johnson's stationary problem has one step.
    Reason
    with_several_steps();

    /// All of them.
    Reason
    all(const std::vector<Reason> &reasons);

    /// Without a condition.
    Reason
    always();
  } // namespace EntryReasons
} // namespace ElastoPlastic

#endif
