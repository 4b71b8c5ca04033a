// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_power_law_h
#define evaluation_power_law_h

#include <utility>
#include <vector>

namespace ElastoPlastic
{
  /// The law of an unloading, force = coefficient (depth -
  /// final_depth)^exponent
  /// @cite oliver_pharr_1992, equation (5).
  struct PowerLaw
  {
    /// (The coefficient of a large exponent may be no number of the machine.)
    double log_coefficient;
    double exponent;
    double final_depth;

    /// Its slope at @p depth > final_depth.
    double
    stiffness(const double depth) const;
  };



  /// The law that is closest to pairs of depth and positive force: the sum of
  /// the squares of the relative deviations of the force is smallest (to first
  /// order, since logarithms are compared). There must be at least three
  /// different depths. Final depths are looked for up to a thousand times the
  /// range of the depths below the smallest.
  PowerLaw
  fit_power_law(const std::vector<std::pair<double, double>> &points);
} // namespace ElastoPlastic

#endif
