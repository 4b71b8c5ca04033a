// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_indenter_pyramid_h
#define indenter_indenter_pyramid_h

#include <memory>

#include "indenter/indenter.h"

namespace ElastoPlastic
{
  /// A regular pyramid: those of Vickers, Berkovich and the corner of a cube.
  /// Its tip is sharp, rounded, or cut off.
  ///
  /// The rounded pyramid is what a ball reaches from inside the sharp one: its
  /// tip is a part of the ball, its edges are parts of cylinders of the same
  /// radius, and both are tangent to the faces, which are plane as before.
  struct PyramidShape
  {
    unsigned int n_faces    = 4;  ///< at least 3
    double       face_angle = 68; ///< between axis and face, in degrees
    /// From the x axis to the horizontal normal of the first face, about the
    /// vertical axis, in degrees.
    double rotation        = 0;
    double rounding_radius = 0; ///< 0: not rounded
    /// The height of what is cut off the sharp tip; 0 if it is rounded.
    double truncation = 0;
  };

  std::unique_ptr<Indenter<3>>
  make_pyramid(const PyramidShape &shape);

  /// Between axis and flank of the cone that displaces the same volume as the
  /// sharp pyramid, in degrees.
  double
  semi_apex_angle_of_cone(const PyramidShape &shape);
} // namespace ElastoPlastic

#endif
