// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_point_field_h
#define output_point_field_h

#include <functional>
#include <string>
#include <vector>

#include "mechanics/solid_operator.h"
#include "output/output_parameters.h"

namespace ElastoPlastic
{
  /// A field that is known at the quadrature points: a number, or a tensor of
  /// three dimensions.
  struct PointField
  {
    std::string  name;
    std::string  quantity;     ///< as in Units::of(), such as "stress"
    unsigned int n_components; ///< 1, or those of the tensor, row by row
    /// Whether it must not become negative where it is extrapolated.
    bool is_positive;
    /// Writes the components.
    std::function<void(const PointResult &point, float *values)> evaluate;
  };



  /// Those that are always written, with the rate of the equivalent plastic
  /// strain if the body @p is_rate_dependent, and then the @p additional ones,
  /// each once.
  std::vector<PointField>
  point_fields(const std::vector<AdditionalField> &additional,
               const bool                          is_rate_dependent);
} // namespace ElastoPlastic

#endif
