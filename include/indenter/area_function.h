// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_area_function_h
#define indenter_area_function_h

#include <deal.II/base/numbers.h>

#include <optional>
#include <vector>

namespace ElastoPlastic
{
  /// The area of a tip's section at the height h above its lowest point, as
  /// laboratories calibrate it: C0 h^2 + C1 h + C2 h^(1/2) + C3 h^(1/4) + ...
  /// @cite oliver_pharr_1992.
  class AreaFunction
  {
  public:
    /// Below, a height counts as zero.
    static constexpr double smallest_height = 1e-100;

    /// @param coefficients C0, C1 and so on.
    explicit AreaFunction(const std::vector<double> &coefficients)
      : coefficients(coefficients)
    {}


    /// The smallest height found at which the area does not grow: then there
    /// is no such tip, and the other functions must not be called.
    std::optional<double>
    height_of_decrease() const;

    /// For a height > 0, as are its derivatives.
    double
    value(const double height) const
    {
      return sum(height, 0);
    }

    double
    derivative(const double height) const
    {
      return sum(height, 1);
    }

    double
    second_derivative(const double height) const
    {
      return sum(height, 2);
    }

    /// The inverse of value(), for an @p area >= 0; infinite beyond the inverse
    /// of the smallest height.
    double
    height(const double area) const;

    /// The curvature of the body of revolution at its lowest point; 0 for a
    /// cone.
    double
    tip_curvature() const
    {
      return is_convex() && coefficients.size() > 1 && coefficients[1] > 0 ?
               2 * dealii::numbers::PI / coefficients[1] :
               0.;
    }

    /// Whether the body of revolution is certainly convex: no power is less
    /// than 1.
    bool
    is_convex() const;

  private:
    /// C_i p (p - 1) ... h^(p - order), summed over all terms.
    double
    sum(const double height, const unsigned int order) const;

    const std::vector<double> coefficients;
  };
} // namespace ElastoPlastic

#endif
