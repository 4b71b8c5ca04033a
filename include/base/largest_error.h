// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_largest_error_h
#define base_largest_error_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace ElastoPlastic
{
  /// Takes @p error into account in the @p largest one of a check. What is not
  /// a number is infinitely wrong.
  inline void
  keep_largest(double &largest, const double error)
  {
    largest =
      std::max(largest,
               std::isnan(error) ? std::numeric_limits<double>::infinity() :
                                   error);
  }
} // namespace ElastoPlastic

#endif
