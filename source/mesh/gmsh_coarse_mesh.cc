// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "mesh/gmsh_coarse_mesh.h"
#include "mesh/mesh_defects.h"

namespace ElastoPlastic
{
  namespace
  {
    std::vector<unsigned int>
    sorted(std::vector<unsigned int> vertices)
    {
      std::sort(vertices.begin(), vertices.end());
      return vertices;
    }



    /// "(1 0.5)", for messages.
    template <int dim>
    std::string
    in_words(const Point<dim> &point)
    {
      std::ostringstream words;
      words << '(' << point << ')';
      return words.str();
    }



    /// Whether the edges at all corners span a volume, of the same sign: cells
    /// may be numbered in either sense. The limit is deal.II's for distorted
    /// cells.
    template <int dim>
    bool
    is_well_shaped(
      const Point<dim> (&corners)[GeometryInfo<dim>::vertices_per_cell])
    {
      Tensor<0, dim> volumes[GeometryInfo<dim>::vertices_per_cell];
      GeometryInfo<dim>::alternating_form_at_vertices(corners, volumes);

      double diameter = 0;
      for (const Point<dim> &a : corners)
        for (const Point<dim> &b : corners)
          diameter = std::max(diameter, a.distance(b));
      const double smallest = 1e-9 * std::pow(diameter, dim);
      const double sign     = (volumes[0] > 0 ? 1 : -1);
      return std::all_of(std::begin(volumes),
                         std::end(volumes),
                         [&](const double volume) {
                           return sign * volume > smallest;
                         });
    }
  } // namespace



  template <int dim>
  GmshCoarseMesh<dim>::GmshCoarseMesh(const GmshContents &contents)
    : contents(contents)
  {
    for (const auto &element : contents.elements)
      if (element.type == cell_type)
        add_cell(element);
    check_shapes();
    check_neighbours();
    original_vertices = separate_pinched_vertices(vertices, cells);
  }



  // Gmsh numbers the nodes of a cell around, deal.II lexicographically.
  template <int dim>
  void
  GmshCoarseMesh<dim>::add_cell(const GmshContents::Element &element)
  {
    cells.emplace_back();
    cells.back().material_id = element.physical_tag;
    for (unsigned int i = 0; i < element.nodes.size(); ++i)
      {
        const unsigned int node = element.nodes[i];
        const auto [vertex, is_new] =
          vertex_of_node.emplace(node, vertices.size());
        if (is_new)
          {
            vertices.emplace_back();
            std::copy_n(&contents.nodes[node][0], dim, &vertices.back()[0]);
          }
        cells.back().vertices[GeometryInfo<dim>::ucd_to_deal[i]] =
          vertex->second;
      }
  }



  template <int dim>
  void
  GmshCoarseMesh<dim>::check_shapes() const
  {
    constexpr unsigned int  n_corners = GeometryInfo<dim>::vertices_per_cell;
    std::vector<Point<dim>> centres; // of distorted cells
    for (const auto &cell : cells)
      {
        Point<dim> corners[n_corners], sum;
        for (unsigned int v = 0; v < n_corners; ++v)
          {
            corners[v] = vertices[cell.vertices[v]];
            sum += corners[v];
          }
        if (!is_well_shaped(corners))
          centres.push_back(sum / n_corners);
      }
    if (!centres.empty())
      contents.reject(
        "the cell with the centre " + in_words(centres.front()) +
        " is distorted (degenerate or turned over at a corner)" +
        (centres.size() == 1 ?
           "" :
           ", the first of " + std::to_string(centres.size()) + " such cells") +
        ". Improve the mesh there.");
  }



  // deal.II relies on at most two cells meeting at a face.
  template <int dim>
  void
  GmshCoarseMesh<dim>::check_neighbours() const
  {
    using Info = GeometryInfo<dim>;
    std::set<Vertices>               known_cells;
    std::map<Vertices, unsigned int> n_cells_at_face;
    for (const auto &cell : cells)
      {
        if (!known_cells
               .insert(sorted({cell.vertices.begin(), cell.vertices.end()}))
               .second)
          contents.reject("two cells have the same nodes, one of them at " +
                          in_words(vertices[cell.vertices[0]]) +
                          ". In Gmsh, put each surface (2D) or volume (3D) "
                          "into one physical group only.");
        for (const unsigned int f : Info::face_indices())
          {
            Vertices face(Info::vertices_per_face);
            for (unsigned int v = 0; v < face.size(); ++v)
              face[v] = cell.vertices[Info::face_to_cell_vertices(f, v)];
            if (++n_cells_at_face[sorted(face)] > 2)
              contents.reject(
                "more than two cells meet at a face with the corner " +
                in_words(vertices[face.front()]) + ": some of them overlap.");
          }
      }
  }



  template <int dim>
  void
  GmshCoarseMesh<dim>::create(Triangulation<dim> &triangulation)
  {
    try
      {
        GridTools::invert_cells_with_negative_measure(vertices, cells);
        GridTools::consistently_order_cells(cells);
        triangulation.create_triangulation(vertices, cells, SubCellData());
      }
    catch (const typename Triangulation<dim>::DistortedCellList &distorted)
      {
        contents.reject("the cell with the centre " +
                        in_words(distorted.distorted_cells.front()->center()) +
                        " is distorted. Improve the mesh there.");
      }
    catch (const ExceptionBase &exception)
      {
        std::ostringstream reason;
        exception.print_info(reason);
        contents.reject(
          "its cells do not fit together; do some overlap? "
          "deal.II says: " +
          Utilities::trim(reason.str()));
      }
    if (const auto vertex = find_hanging_vertex(triangulation))
      contents.reject(
        "the corner " + in_words(*vertex) +
        " of a cell lies inside an edge of another one. Cells must meet at "
        "whole faces; smaller ones beside larger ones are made by 'Local "
        "refinements' and 'Refinement'.");
  }



  template <int dim>
  typename GmshCoarseMesh<dim>::Vertices
  GmshCoarseMesh<dim>::vertices_of(const std::vector<unsigned int> &nodes) const
  {
    Vertices result;
    for (const unsigned int node : nodes)
      if (const auto vertex = vertex_of_node.find(node);
          vertex != vertex_of_node.end())
        result.push_back(vertex->second);
    return sorted(result);
  }



  template <int dim>
  typename GmshCoarseMesh<dim>::Vertices
  GmshCoarseMesh<dim>::vertices_of(
    const typename Triangulation<dim>::face_iterator &face) const
  {
    Vertices result;
    for (const unsigned int v : face->vertex_indices())
      result.push_back(original_vertices[face->vertex_index(v)]);
    return sorted(result);
  }



  template class GmshCoarseMesh<2>;
  template class GmshCoarseMesh<3>;
} // namespace ElastoPlastic
