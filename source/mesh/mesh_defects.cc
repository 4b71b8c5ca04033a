// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/numerics/rtree.h>

#include <boost/pending/disjoint_sets.hpp>

#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "mesh/mesh_defects.h"

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



  template <int dim>
  std::optional<Point<dim>>
  find_slit(const Triangulation<dim> &mesh)
  {
    constexpr double rounding = 1e-8;

    std::vector<Point<dim>>       centres;
    std::vector<BoundingBox<dim>> surroundings;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            centres.push_back(face->center());
            surroundings.emplace_back(
              std::make_pair(centres.back(), centres.back()));
            surroundings.back().extend(rounding * face->diameter());
          }

    namespace bgi   = boost::geometry::index;
    const auto tree = pack_rtree(centres);
    for (unsigned int i = 0; i < centres.size(); ++i)
      {
        std::vector<Point<dim>> near;
        tree.query(bgi::intersects(surroundings[i]), std::back_inserter(near));
        if (near.size() > 1)
          return centres[i];
      }
    return {};
  }



  template std::optional<Point<2>>
  find_slit(const Triangulation<2> &);
  template std::optional<Point<3>>
  find_slit(const Triangulation<3> &);



  template <int dim>
  std::vector<unsigned int>
  separate_pinched_vertices(std::vector<Point<dim>>    &vertices,
                            std::vector<CellData<dim>> &cells)
  {
    using Info = GeometryInfo<dim>;
    // The corners of all cells, and which of them are the same vertex because
    // they belong to a common face, which is recognised by its vertices.
    constexpr unsigned int              n_corners = Info::vertices_per_cell;
    boost::disjoint_sets_with_storage<> same_vertex(cells.size() * n_corners);
    using Corners = std::map<unsigned int, unsigned int>; // by vertex
    std::map<std::vector<unsigned int>, Corners> first_cell_at_face;
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (const unsigned int f : Info::face_indices())
        {
          Corners corners;
          for (unsigned int v = 0; v < Info::vertices_per_face; ++v)
            {
              const unsigned int corner = Info::face_to_cell_vertices(f, v);
              corners[cells[c].vertices[corner]] = c * n_corners + corner;
            }
          std::vector<unsigned int> face;
          for (const auto &[vertex, corner] : corners)
            face.push_back(vertex);
          const auto [first, is_new] =
            first_cell_at_face.emplace(face, corners);
          if (!is_new)
            for (const auto &[vertex, corner] : corners)
              same_vertex.union_set(corner, first->second.at(vertex));
        }

    std::vector<unsigned int> original(vertices.size());
    std::iota(original.begin(), original.end(), 0U);
    std::map<unsigned int, unsigned int> vertex_of_set;
    std::vector<bool>                    is_taken(vertices.size(), false);
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int corner = 0; corner < n_corners; ++corner)
        {
          unsigned int &vertex = cells[c].vertices[corner];
          const auto [number, is_new] =
            vertex_of_set.emplace(same_vertex.find_set(c * n_corners + corner),
                                  vertex);
          if (is_new && is_taken[vertex])
            {
              number->second = vertices.size();
              vertices.push_back(Point<dim>(vertices[vertex]));
              original.push_back(vertex);
            }
          else if (is_new)
            is_taken[vertex] = true;
          vertex = number->second;
        }
    return original;
  }



  template std::vector<unsigned int>
  separate_pinched_vertices(std::vector<Point<2>> &,
                            std::vector<CellData<2>> &);
  template std::vector<unsigned int>
  separate_pinched_vertices(std::vector<Point<3>> &,
                            std::vector<CellData<3>> &);
} // namespace ElastoPlastic
