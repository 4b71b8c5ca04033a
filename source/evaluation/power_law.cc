// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>

#include "evaluation/indentation_test.h"

namespace ElastoPlastic
{
  namespace
  {
    using Points = std::vector<std::pair<double, double>>;

    /// The best law with a given final depth: linear regression of the
    /// logarithms.
    PowerLaw
    fit_with_final_depth(const Points &points, const double final_depth)
    {
      double mean_x = 0, mean_y = 0;
      for (const auto &[depth, force] : points)
        {
          mean_x += std::log(depth - final_depth) / points.size();
          mean_y += std::log(force) / points.size();
        }
      double covariance = 0, variance = 0;
      for (const auto &[depth, force] : points)
        {
          const double x = std::log(depth - final_depth) - mean_x;
          covariance += x * (std::log(force) - mean_y);
          variance += x * x;
        }
      const double exponent = covariance / variance;
      return {mean_y - exponent * mean_x, exponent, final_depth};
    }



    double
    sum_of_squares(const PowerLaw &law, const Points &points)
    {
      double sum = 0;
      for (const auto &[depth, force] : points)
        {
          const double deviation =
            law.log_coefficient - std::log(force) +
            law.exponent * std::log(depth - law.final_depth);
          sum += deviation * deviation;
        }
      return sum;
    }
  } // namespace



  PowerLaw
  fit_power_law(const std::vector<std::pair<double, double>> &points)
  {
    const auto [lowest, highest] =
      std::minmax_element(points.begin(), points.end());
    const double smallest_depth = lowest->first;
    const double range          = highest->first - smallest_depth;

    const auto fit = [&](const double log_distance) {
      return fit_with_final_depth(points,
                                  smallest_depth -
                                    range * std::exp(log_distance));
    };
    const double log_distance =
      boost::math::tools::brent_find_minima(
        [&](const double x) { return sum_of_squares(fit(x), points); },
        std::log(1e-3),
        std::log(1e3),
        std::numeric_limits<double>::digits / 2)
        .first;
    return fit(log_distance);
  }
} // namespace ElastoPlastic
