// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_units_h
#define output_units_h

#include <string>

namespace ElastoPlastic
{
  /// What the user calls the units of length and force. No number depends on
  /// them.
  struct Units
  {
    std::string length; ///< empty if it has no name
    std::string force;  ///< likewise

    /// Whether both have a name.
    bool
    are_named() const;

    /// The unit of a @p quantity, as the columns of the tables call them:
    /// "force", "force x length", "stress" and so on. A quantity that is none
    /// of force and length, or whose units have no names, stays as it is.
    std::string
    of(const std::string &quantity) const;
  };
} // namespace ElastoPlastic

#endif
