// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "indenter/indenter_stl_surface.h"

namespace ElastoPlastic
{
  namespace
  {
    namespace bgi = boost::geometry::index;



    Point<2>
    seen_from_above(const Point<3> &p)
    {
      return {p[0], p[1]};
    }



    std::vector<Facet>
    with_lowest_corner_at_zero(std::vector<Facet> facets)
    {
      double lowest = std::numeric_limits<double>::infinity();
      for (const Facet &facet : facets)
        for (const Point<3> &corner : facet)
          lowest = std::min(lowest, corner[2]);
      for (Facet &facet : facets)
        for (Point<3> &corner : facet)
          corner[2] -= lowest;
      return facets;
    }



    double
    horizontal_size(const std::vector<Facet> &facets)
    {
      std::vector<Point<2>> corners;
      for (const Facet &facet : facets)
        for (const Point<3> &corner : facet)
          corners.push_back(seen_from_above(corner));
      const auto ends = BoundingBox<2>(corners).get_boundary_points();
      return ends.first.distance(ends.second);
    }



    RTree<std::pair<BoundingBox<2>, unsigned int>>
    pack_boxes(const std::vector<Facet> &facets, const double tolerance)
    {
      std::vector<std::pair<BoundingBox<2>, unsigned int>> boxes;
      for (const Facet &facet : facets)
        {
          BoundingBox<2> box(std::vector<Point<2>>{seen_from_above(facet[0]),
                                                   seen_from_above(facet[1]),
                                                   seen_from_above(facet[2])});
          box.extend(tolerance);
          boxes.emplace_back(box, boxes.size());
        }
      return pack_rtree(boxes);
    }



    double
    cross_product(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }



    /// Whether @p x is above or below a triangle, or within the tolerance of
    /// it.
    bool
    contains(const Facet &facet, const Point<2> &x, const double tolerance)
    {
      const Point<2> a       = seen_from_above(facet[0]),
                     b       = seen_from_above(facet[1]),
                     c       = seen_from_above(facet[2]);
      const double sign      = cross_product(b - a, c - a) > 0 ? 1 : -1;
      const auto   is_inside = [&](const Point<2> &from, const Point<2> &to) {
        return sign * cross_product(to - from, x - from) >=
               -tolerance * (to - from).norm();
      };
      return is_inside(a, b) && is_inside(b, c) && is_inside(c, a);
    }



    /// The surface is a triangle's plane, within the triangle's heights.
    IndenterSurface<3>
    plane_above(const Facet &facet, const Point<2> &x)
    {
      const Tensor<1, 3> u = facet[1] - facet[0], v = facet[2] - facet[0];
      const Tensor<1, 3> normal = cross_product_3d(u, v);
      Tensor<1, 2>       slope;
      for (unsigned int d = 0; d < 2; ++d)
        slope[d] = -normal[d] / normal[2];
      const auto [lowest, highest] =
        std::minmax({facet[0][2], facet[1][2], facet[2][2]});
      return {std::clamp(facet[0][2] + slope * (x - seen_from_above(facet[0])),
                         lowest,
                         highest),
              slope,
              {}};
    }



    /// Twice the area of the part of a triangle below a height, seen from
    /// above; negative if the triangle's outside is below.
    double
    twice_the_area_below(const Facet &facet, const double height)
    {
      std::vector<Point<2>> polygon;
      for (unsigned int v = 0; v < 3; ++v)
        {
          const Point<3> &from = facet[v], &to = facet[(v + 1) % 3];
          if (from[2] < height)
            polygon.push_back(seen_from_above(from));
          if ((from[2] < height) != (to[2] < height))
            polygon.push_back(seen_from_above(
              from + (height - from[2]) / (to[2] - from[2]) * (to - from)));
        }
      double area = 0;
      for (unsigned int v = 2; v < polygon.size(); ++v)
        area +=
          cross_product(polygon[v - 1] - polygon[0], polygon[v] - polygon[0]);
      return area;
    }
  } // namespace



  // Nodes lie on the edges of triangles, up to rounding: that of single
  // precision, or of the six digits of many texts.
  template <int dim>
  IndenterStlSurface<dim>::IndenterStlSurface(const std::vector<Facet> &facets)
    : facets(with_lowest_corner_at_zero(facets))
    , tolerance(1e-6 * horizontal_size(facets))
    , boxes(pack_boxes(facets, tolerance))
  {}



  template <int dim>
  IndenterSurface<dim>
  IndenterStlSurface<dim>::surface(const Point<dim - 1> &x) const
  {
    Point<2> point;
    for (unsigned int d = 0; d < dim - 1; ++d)
      point[d] = x[d];

    IndenterSurface<3> lowest{std::numeric_limits<double>::infinity(), {}, {}};
    for (const Box &box :
         boxes | bgi::adaptors::queried(bgi::intersects(point)))
      if (contains(facets[box.second], point, tolerance))
        {
          const IndenterSurface<3> plane =
            plane_above(facets[box.second], point);
          if (plane.height < lowest.height)
            lowest = plane;
        }

    IndenterSurface<dim> result{lowest.height, {}, {}};
    for (unsigned int d = 0; d < dim - 1; ++d)
      result.slope[d] = lowest.slope[d];
    return result;
  }



  template <int dim>
  double
  IndenterStlSurface<dim>::section_area(const double height) const
  {
    if (dim == 2)
      return Indenter<dim>::section_area(height);
    double sum = 0;
    for (const Facet &facet : facets)
      sum += twice_the_area_below(facet, height);
    return 0.5 * std::abs(sum);
  }



  template class IndenterStlSurface<2>;
  template class IndenterStlSurface<3>;
} // namespace ElastoPlastic
