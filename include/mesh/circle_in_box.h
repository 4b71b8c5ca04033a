// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_circle_in_box_h
#define mesh_circle_in_box_h

#include <deal.II/grid/tria.h>

#include "mesh/disc.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Divides the cells of a coarse mesh of rectangles around the centre of a
  /// @p disc, one to four of them, into five each, so that the edges of cells
  /// pass along the circle: three of each inside, two outside. Boundary ids
  /// are kept, all cells have the material id 0.
  /// @return false, with the mesh as it was, if the centre is not a vertex of
  /// the mesh, or if the disc does not fit into the cells around it.
  bool
  divide_around_circle(const Disc<2> &disc, Triangulation<2> &mesh);

  /// Lets refinement of a coarse mesh that has been made of such a section
  /// follow the cylinder above and below the circle.
  void
  follow_circle(const Disc<2> &disc, Triangulation<3> &mesh);
} // namespace ElastoPlastic

#endif
