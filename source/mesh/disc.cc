// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/disc.h"

namespace ElastoPlastic
{
  namespace
  {
    double
    distance(const Disc<2> &disc, const Point<3> &x)
    {
      return disc.centre.distance(from_above(x));
    }



    /// The distance of the centre from a triangle seen from above is 0 inside.
    double
    distance(const Disc<2> &disc, const std::array<Point<3>, 3> &triangle)
    {
      double       least  = std::numeric_limits<double>::infinity();
      unsigned int n_left = 0, n_right = 0;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Point<2>     a    = from_above(triangle[i]);
          const Tensor<1, 2> side = from_above(triangle[(i + 1) % 3]) - a,
                             to   = disc.centre - a;
          const double length     = side.norm_square(),
                       t          = length > 0. ?
                                      std::clamp((to * side) / length, 0., 1.) :
                                      0.;
          least                   = std::min(least, (to - t * side).norm());
          const double turn       = cross_product_2d(side) * to;
          n_left += turn > 0.;
          n_right += turn < 0.;
        }
      return n_left == 3 || n_right == 3 ? 0. : least;
    }



    using Cell = Triangulation<2>::cell_iterator;



    std::optional<unsigned int>
    vertex_at(const Point<2> &x, const Cell &cell)
    {
      for (const unsigned int v : cell->vertex_indices())
        if (cell->vertex(v).distance(x) < 1e-10 * cell->diameter())
          return v;
      return {};
    }



    /// The corners of the new cells in a quadrant: along x, along y, and on the
    /// diagonal.
    std::vector<Point<2>>
    corners_in_quadrant(const Disc<2>      &disc,
                        const Tensor<1, 2> &along_x,
                        const Tensor<1, 2> &along_y)
    {
      const Tensor<1, 2> x        = disc.radius / along_x.norm() * along_x,
                         y        = disc.radius / along_y.norm() * along_y,
                         diagonal = std::sqrt(0.5) * (x + y);
      const auto at               = [&](const Tensor<1, 2> &offset) {
        return Point<2>(disc.centre + offset);
      };
      return {disc.centre,
              at(0.5 * x),
              at(x),
              at(along_x),
              at(0.5 * y),
              at(y),
              at(along_y),
              at(0.5 * diagonal),
              at(diagonal),
              at(along_x + along_y)};
    }



    // The corners of cells are numbered lexicographically, in the quadrant in
    // which x and y grow; in the quadrants beside it, the sense of rotation is
    // another one.
    void
    add_quadrant(const Disc<2>            &disc,
                 const Cell               &cell,
                 const unsigned int        center,
                 std::vector<Point<2>>    &vertices,
                 std::vector<CellData<2>> &cells)
    {
      constexpr std::array<std::array<unsigned int, 4>, 5> new_cells = {
        {{{0, 1, 4, 7}},
         {{1, 2, 7, 8}},
         {{4, 7, 5, 8}},
         {{2, 3, 8, 9}},
         {{5, 8, 6, 9}}}};

      const auto along = [&](const unsigned int bit) {
        return cell->vertex(center ^ bit) - cell->vertex(center);
      };
      const unsigned int first = vertices.size();
      for (const Point<2> &x : corners_in_quadrant(disc, along(1), along(2)))
        vertices.push_back(x);
      const bool is_turned = center == 1 || center == 2;
      for (const auto &corners : new_cells)
        {
          CellData<2> &data = cells.emplace_back();
          for (unsigned int v = 0; v < 4; ++v)
            data.vertices[v] = first + corners[v];
          if (is_turned)
            std::swap(data.vertices[1], data.vertices[2]);
        }
    }



    /// Numbers the boundaries of a box like colorize.
    void
    set_boundary_ids(const std::pair<Point<2>, Point<2>> &box,
                     Triangulation<2>                    &mesh)
    {
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            for (unsigned int d = 0; d < 2; ++d)
              for (const bool is_upper : {false, true})
                if (std::abs(face->center()[d] -
                             (is_upper ? box.second : box.first)[d]) <
                    1e-10 * (box.second[d] - box.first[d]))
                  face->set_boundary_id(2 * d + is_upper);
    }
  } // namespace



  bool
  contains(const Disc<2> &disc, const std::array<Point<3>, 3> &triangle)
  {
    return std::all_of(triangle.begin(), triangle.end(), [&](const auto &x) {
      return distance(disc, x) <= (1. + rounding_of_circle) * disc.radius;
    });
  }



  bool
  overlaps(const Disc<2> &disc, const std::array<Point<3>, 3> &triangle)
  {
    return distance(disc, triangle) < (1. - rounding_of_circle) * disc.radius;
  }



  bool
  is_on_edge(const Disc<2> &disc, const Point<3> &x)
  {
    return std::abs(distance(disc, x) - disc.radius) <=
           rounding_of_circle * disc.radius;
  }



  bool
  divide_around_circle(const Disc<2> &disc, Triangulation<2> &mesh)
  {
    const auto box =
      GridTools::compute_bounding_box(mesh).get_boundary_points();
    std::vector<Point<2>>    vertices = mesh.get_vertices();
    std::vector<CellData<2>> cells;
    bool                     is_there = false;
    for (const auto &cell : mesh.active_cell_iterators())
      if (const auto center = vertex_at(disc.centre, cell))
        {
          is_there = true;
          if (cell->minimum_vertex_distance() <= disc.radius)
            return false;
          add_quadrant(disc, cell, *center, vertices, cells);
        }
      else
        {
          CellData<2> &data = cells.emplace_back();
          for (const unsigned int v : cell->vertex_indices())
            data.vertices[v] = cell->vertex_index(v);
        }
    if (!is_there)
      return false;

    SubCellData               no_boundaries;
    std::vector<unsigned int> all;
    GridTools::delete_duplicated_vertices(
      vertices, cells, no_boundaries, all, 1e-10 * disc.radius);
    // (What is extruded must not have lines of two senses.)
    GridTools::consistently_order_cells(cells);
    mesh.clear();
    mesh.create_triangulation(vertices, cells, no_boundaries);
    set_boundary_ids(box, mesh);
    return true;
  }



  void
  follow_circle(const Disc<2> &disc, Triangulation<3> &mesh)
  {
    constexpr types::manifold_id cylinder = 0;

    const auto is_on_cylinder = [&](const auto &object) {
      for (const unsigned int v : object->vertex_indices())
        if (!is_on_edge(disc, object->vertex(v)))
          return false;
      return true;
    };
    mesh.set_all_manifold_ids(numbers::flat_manifold_id);
    mesh.set_manifold(
      cylinder,
      CylindricalManifold<3>(Point<3>::unit_vector(2),
                             Point<3>(disc.centre[0], disc.centre[1], 0.)));
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (is_on_cylinder(face))
          face->set_all_manifold_ids(cylinder);
  }
} // namespace ElastoPlastic
