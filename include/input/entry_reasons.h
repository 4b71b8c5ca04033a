// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef input_entry_reasons_h
#define input_entry_reasons_h

#include <functional>
#include <string>
#include <vector>

#include "input/entry_effects.h"

namespace ElastoPlastic
{
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
