// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>

#include <boost/pending/disjoint_sets.hpp>

#include <map>
#include <numeric>
#include <utility>

#include "mesh/pinched_vertices.h"

namespace ElastoPlastic
{
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
