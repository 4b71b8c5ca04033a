// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_disc_h
#define mesh_disc_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <array>

namespace ElastoPlastic
{
  using namespace dealii;

  /// A disc in the horizontal plane; an interval if there is a single
  /// horizontal direction.
  template <int dim>
  struct Disc
  {
    Point<dim> centre;
    double     radius;
  };



  /// The part of the radius by which rounding errors of the coordinates may put
  /// a point on the wrong side of the circle.
  constexpr double rounding_of_circle = 1e-10;

  /// Where a point is, seen from above.
  inline Point<2>
  from_above(const Point<3> &x)
  {
    return {x[0], x[1]};
  }

  /// Whether a triangle lies on the disc, seen from above: exactly, but for
  /// rounding.
  bool
  contains(const Disc<2> &disc, const std::array<Point<3>, 3> &triangle);

  /// Whether a triangle and the interior of the disc have points in common,
  /// seen from above: exactly, but for rounding. Not if they only touch.
  bool
  overlaps(const Disc<2> &disc, const std::array<Point<3>, 3> &triangle);

  /// Whether a point lies on the circle around the disc, but for rounding.
  bool
  is_on_edge(const Disc<2> &disc, const Point<3> &x);



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
