// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "indenter/area_function.h"

namespace ElastoPlastic
{
  using namespace dealii;



  std::optional<double>
  AreaFunction::height_of_decrease() const
  {
    const double ratio = 1.05;
    for (double height = smallest_height; height < 1 / smallest_height;
         height *= ratio)
      if (!(derivative(height) > 0))
        return height;
    return {};
  }



  // The root is that of the logarithms, which are nearly proportional.
  double
  AreaFunction::height(const double area) const
  {
    const auto excess = [&](const double logarithm) {
      return std::log(value(std::exp(logarithm)) / area);
    };
    const double lowest = std::log(smallest_height);
    if (excess(lowest) >= 0)
      return 0.;
    if (excess(-lowest) <= 0)
      return std::numeric_limits<double>::infinity();
    std::uintmax_t n_iterations = 200;
    const auto     interval     = boost::math::tools::toms748_solve(
      excess,
      lowest,
      -lowest,
      boost::math::tools::eps_tolerance<double>(),
      n_iterations);
    return std::exp(0.5 * (interval.first + interval.second));
  }



  bool
  AreaFunction::is_convex() const
  {
    return std::all_of(coefficients.begin() +
                         std::min<std::size_t>(2, coefficients.size()),
                       coefficients.end(),
                       [](const double c) { return c == 0; });
  }



  double
  AreaFunction::sum(const double height, const unsigned int order) const
  {
    double result = 0, power = 2;
    for (const double coefficient : coefficients)
      {
        double factor = coefficient;
        for (unsigned int i = 0; i < order; ++i)
          factor *= power - i;
        if (factor != 0)
          result += factor * std::pow(height, power - order);
        power /= 2;
      }
    return result;
  }
} // namespace ElastoPlastic
