// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_refusal_h
#define tests_refusal_h

#include <string>

#include "base/exceptions.h"

/// The message of the InputError with which @p action ends; without one,
/// @p otherwise.
template <typename Action>
std::string
refusal(const Action &action, const std::string &otherwise = "accepted")
{
  try
    {
      action();
    }
  catch (const ElastoPlastic::InputError &error)
    {
      return error.what();
    }
  return otherwise;
}

#endif
