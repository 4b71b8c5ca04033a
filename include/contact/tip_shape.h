// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_tip_shape_h
#define contact_tip_shape_h

#include <functional>

#include "contact/indenter_parameters.h"

namespace ElastoPlastic
{
  /// What the evaluation of an indentation test needs to know of the indenter.
  struct TipShape
  {
    /// epsilon of @cite oliver_pharr_1992, equation (4): 1 for a flat face,
    /// 2 - 4/pi (there rounded to 0.72) for a cone, 0.75 for all others, as is
    /// exact for a paraboloid.
    double depth_factor;

    /// The area of the horizontal section at a height > 0 above the tip, of the
    /// whole indenter; 0 if it is not bounded.
    std::function<double(const double height)> section_area;
  };

  /// The tip of an indenter in three dimensions, or of one that is a body of
  /// revolution if dim is 2. Sections are taken to be star-shaped about the
  /// position of the indenter; height maps, which have no single tip, are
  /// treated as if their sections were not bounded.
  /// @p parameters must have passed their check, and not be of type "none".
  template <int dim>
  TipShape
  make_tip_shape(const IndenterParameters &parameters);
} // namespace ElastoPlastic

#endif
