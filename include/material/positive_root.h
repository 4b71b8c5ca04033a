// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_positive_root_h
#define material_positive_root_h

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace ElastoPlastic
{
  /// A root x > 0, up to rounding, of a continuous @p function that is positive
  /// at 0, @p value_at_zero, and not so far beyond: the root is enclosed
  /// between 0 and @p upper > 0, which is doubled until the function has
  /// changed its sign. Not a number if it never does.
  template <typename Function>
  double
  positive_root(const Function &function,
                const double    value_at_zero,
                double          upper)
  {
    double value = function(upper);
    while (value > 0 && std::isfinite(upper))
      value = function(upper *= 2.);
    if (!(value <= 0))
      return std::numeric_limits<double>::quiet_NaN();
    if (value == 0)
      return upper;

    std::uintmax_t max_iterations = 200;
    const auto [below, above]     = boost::math::tools::toms748_solve(
      function,
      0.,
      upper,
      value_at_zero,
      value,
      boost::math::tools::eps_tolerance<double>(
        std::numeric_limits<double>::digits - 1),
      max_iterations);
    return 0.5 * (below + above);
  }
} // namespace ElastoPlastic

#endif
