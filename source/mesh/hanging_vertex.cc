// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <set>
#include <vector>

#include "mesh/hanging_vertex.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Two cells without a face in common have all their faces there on the
    /// boundary: the edges and vertices of those are enough.
    template <int dim>
    struct BoundaryEdges
    {
      explicit BoundaryEdges(const Triangulation<dim> &mesh)
      {
        for (const auto &cell : mesh.active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary())
              {
                for (const unsigned int v : face->vertex_indices())
                  vertices.insert(face->vertex_index(v));
                if constexpr (dim == 2)
                  add(*face);
                else
                  for (unsigned int l = 0; l < face->n_lines(); ++l)
                    add(*face->line(l));
              }
      }

      template <typename Line>
      void
      add(const Line &line)
      {
        edges.insert({line.vertex_index(0), line.vertex_index(1)});
      }

      std::set<unsigned int>                          vertices;
      std::set<std::pair<unsigned int, unsigned int>> edges;
    };



    template <int dim>
    bool
    is_inside(const Point<dim> &vertex,
              const Point<dim> &first,
              const Point<dim> &second)
    {
      const double         rounding = 1e-8;
      const Tensor<1, dim> edge     = second - first;
      const double         share = (vertex - first) * edge / edge.norm_square();
      return share > rounding && share < 1 - rounding &&
             vertex.distance(first + share * edge) < rounding * edge.norm();
    }
  } // namespace



  template <int dim>
  std::optional<Point<dim>>
  find_hanging_vertex(const Triangulation<dim> &mesh)
  {
    const auto              &vertices = mesh.get_vertices();
    const BoundaryEdges<dim> boundary(mesh);
    const std::vector<std::pair<unsigned int, unsigned int>> edges(
      boundary.edges.begin(), boundary.edges.end());
    std::vector<BoundingBox<dim>> boxes;
    for (const auto &[first, second] : edges)
      {
        boxes.emplace_back(
          std::vector<Point<dim>>{vertices[first], vertices[second]});
        boxes.back().extend(1e-8 * vertices[first].distance(vertices[second]));
      }

    namespace bgi   = boost::geometry::index;
    const auto tree = pack_rtree_of_indices(boxes);
    for (const unsigned int v : boundary.vertices)
      for (const auto i :
           tree | bgi::adaptors::queried(bgi::intersects(vertices[v])))
        if (is_inside(vertices[v],
                      vertices[edges[i].first],
                      vertices[edges[i].second]))
          return vertices[v];
    return {};
  }



  template std::optional<Point<2>>
  find_hanging_vertex(const Triangulation<2> &);
  template std::optional<Point<3>>
  find_hanging_vertex(const Triangulation<3> &);
} // namespace ElastoPlastic
