// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_tip_shape_h
#define indenter_tip_shape_h

namespace ElastoPlastic
{
  /// What the evaluation of an indentation test needs to know of the indenter,
  /// in three dimensions or as an axisymmetric body.
  class TipShape
  {
  public:
    virtual ~TipShape() = default;

    /// epsilon of @cite oliver_pharr_1992, equation (4): 1 for a flat face,
    /// 2 - 4/pi (there rounded to 0.72) for a cone, 0.75 for all others, as is
    /// exact for a paraboloid.
    virtual double
    depth_factor() const = 0;

    /// The area of the horizontal section at a @p height > 0 above the tip, of
    /// the whole indenter; 0 if it is not bounded, or if there is no single
    /// tip.
    virtual double
    section_area(const double height) const = 0;
  };
} // namespace ElastoPlastic

#endif
