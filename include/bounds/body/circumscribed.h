// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_circumscribed_h
#define bounds_body_circumscribed_h

#include "bounds/body/split_body.h"

namespace ElastoPlastic
{
  /// The same body with another mesh, for mechanisms: the faces that the
  /// indenter reaches cover a polygon around its disc, not only one inside.
  ///
  /// The whole faces on a disc cover an inscribed polygon, if vertices of the
  /// mesh lie on the circle. These are moved outwards, so far that the edges
  /// between them leave the circle: the faces beside them are then no longer
  /// reached. Nothing else changes.
  ///
  /// The result is @p body itself if there is no disc; if no vertices are on
  /// the circle; and if moving them would change the boundary of the body or
  /// its conditions, or the material of a point, or turn over a tetrahedron.
  /// Mechanisms on either mesh give an upper bound.
  SplitBody<3>
  circumscribe(const SplitBody<3> &body);

  /// In the plane, sides end where the indenter does.
  inline SplitBody<2>
  circumscribe(const SplitBody<2> &body)
  {
    return body;
  }
} // namespace ElastoPlastic

#endif
