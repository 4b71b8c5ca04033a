// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <cmath>

#include "mesh/nested_shells.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Exactly zero where the sine or the cosine should be.
    Point<2>
    point_on_circle(const double angle)
    {
      Point<2> result(std::cos(angle), std::sin(angle));
      for (unsigned int d = 0; d < 2; ++d)
        if (std::abs(result[d]) < 1e-14)
          result[d] = 0;
      return result;
    }
  } // namespace



  DividedSector::DividedSector(const double       angle,
                               const unsigned int n_triangles)
  {
    const double half         = 0.5 * angle / n_triangles;
    const double third_of_pi  = numbers::PI / 3;
    const double inner_radius = 0.5;
    const double middle_radius =
      inner_radius * std::sin(third_of_pi + half) / std::sin(third_of_pi);
    const auto add = [this](const double radius, const double phi) {
      vertices.push_back(Point<2>(radius * point_on_circle(phi)));
      return static_cast<unsigned int>(vertices.size() - 1);
    };
    const unsigned int axis  = add(0., 0.);
    unsigned int       inner = add(inner_radius, 0.);
    unsigned int       outer = add(1., 0.);
    arc.push_back(outer);
    for (unsigned int i = 0; i < n_triangles; ++i)
      {
        const double       phi        = (2 * i + 1) * half;
        const unsigned int middle     = add(middle_radius, phi);
        const unsigned int arc_middle = add(1., phi);
        const unsigned int next_inner = add(inner_radius, phi + half);
        const unsigned int next_outer = add(1., phi + half);
        cells.push_back({{axis, inner, next_inner, middle}});
        cells.push_back({{inner, outer, middle, arc_middle}});
        cells.push_back({{next_inner, middle, next_outer, arc_middle}});
        arc.push_back(arc_middle);
        arc.push_back(next_outer);
        inner = next_inner;
        outer = next_outer;
      }
  }



  NestedShells::NestedShells(const DividedSector        &sector,
                             const std::vector<Surface> &surfaces)
    : sector(sector)
  {
    SurfaceVertices last = add_core(surfaces.front());
    for (unsigned int i = 1; i < surfaces.size(); ++i)
      last = add_shell(last, surfaces[i]);
  }



  unsigned int
  NestedShells::add_vertex(const double x, const double y, const double z)
  {
    all_vertices.emplace_back(x, y, z);
    return all_vertices.size() - 1;
  }



  NestedShells::Numbers
  NestedShells::add_floor(const Surface &surface)
  {
    Numbers      floor;
    const double radius = surface.corner * surface.radius;
    for (const Point<2> &x : sector.vertices)
      floor.push_back(
        add_vertex(radius * x[0],
                   radius * x[1],
                   -surface.depth * (1 - (1 - surface.corner) * x.square())));
    return floor;
  }



  NestedShells::SurfaceVertices
  NestedShells::add_core(const Surface &surface)
  {
    Numbers roof;
    for (const Point<2> &x : sector.vertices)
      roof.push_back(
        add_vertex(surface.radius * x[0], surface.radius * x[1], 0.));
    const SurfaceVertices core = {add_floor(surface), on_arc(roof)};
    add_cells_between(core.floor, roof);
    return core;
  }



  NestedShells::SurfaceVertices
  NestedShells::add_shell(const SurfaceVertices &inside, const Surface &surface)
  {
    SurfaceVertices outside = {add_floor(surface), {}};
    for (const unsigned int v : sector.arc)
      outside.rim.push_back(add_vertex(surface.radius * sector.vertices[v][0],
                                       surface.radius * sector.vertices[v][1],
                                       0.));
    add_cells_between(outside.floor, inside.floor);
    add_ring(inside, outside);
    return outside;
  }



  NestedShells::Numbers
  NestedShells::on_arc(const Numbers &of_sector) const
  {
    Numbers result;
    for (const unsigned int v : sector.arc)
      result.push_back(of_sector[v]);
    return result;
  }



  void
  NestedShells::add_cells_between(const Numbers &lower, const Numbers &upper)
  {
    for (const auto &quadrilateral : sector.cells)
      {
        CellData<3> cell;
        for (unsigned int v = 0; v < 4; ++v)
          {
            cell.vertices[v]     = lower[quadrilateral[v]];
            cell.vertices[v + 4] = upper[quadrilateral[v]];
          }
        all_cells.push_back(cell);
      }
  }



  // Cells agree on the direction of the edges that they share, as deal.II
  // wants it: upwards and inwards; on arcs, towards the middle of each
  // triangle.
  void
  NestedShells::add_ring(const SurfaceVertices &inside,
                         const SurfaceVertices &outside)
  {
    const Numbers inner = on_arc(inside.floor), outer = on_arc(outside.floor);
    for (unsigned int j = 0; j + 1 < sector.arc.size(); ++j)
      {
        const unsigned int n = j + 1;
        CellData<3>        cell;
        if (j % 2 == 0)
          cell.vertices = {outer[j],
                           outer[n],
                           inner[j],
                           inner[n],
                           outside.rim[j],
                           outside.rim[n],
                           inside.rim[j],
                           inside.rim[n]};
        else
          cell.vertices = {outer[n],
                           inner[n],
                           outer[j],
                           inner[j],
                           outside.rim[n],
                           inside.rim[n],
                           outside.rim[j],
                           inside.rim[j]};
        all_cells.push_back(cell);
      }
  }

} // namespace ElastoPlastic
