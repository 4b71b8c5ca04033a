// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <map>

#include "base/compatibility.h"
#include "bounds/mesh/cut_cells.h"

namespace ElastoPlastic
{
  namespace
  {
    using VertexNumber = types::global_dof_index;



    /// Where vertices are in the unit cell.
    template <int dim>
    using UnitPositions = std::map<VertexNumber, Point<dim>>;



    template <int dim>
    Point<dim>
    middle(const Point<dim> &a, const Point<dim> &b)
    {
      return Point<dim>(0.5 * (a + b));
    }



    /// Of the corners, and of the middles of edges and faces that are refined.
    template <int dim>
    UnitPositions<dim>
    unit_positions_of(
      const typename DoFHandler<dim>::active_cell_iterator &cell)
    {
      UnitPositions<dim> positions;
      for (const unsigned int v : cell->vertex_indices())
        positions[cell->vertex_dof_index(v, 0)] =
          GeometryInfo<dim>::unit_cell_vertex(v);
      const auto at = [&](const auto &object, const unsigned int vertex) {
        return positions.at(object->vertex_dof_index(vertex, 0));
      };
      for (const unsigned int l : cell->line_indices())
        if (const auto line = cell->line(l); line->has_children())
          positions[line->child(0)->vertex_dof_index(1, 0)] =
            middle(at(line, 0), at(line, 1));
      if constexpr (dim == 3)
        for (const auto &face : cell->face_iterators())
          if (face->has_children())
            positions[face->child(0)->vertex_dof_index(3, 0)] =
              middle(at(face, 0), at(face, 3));
      return positions;
    }



    /// A corner or hanging node of a quadrilateral, and the boundary of the
    /// side that begins there.
    template <int dim>
    struct AroundQuadrilateral
    {
      FacetCorner<dim>   corner;
      types::boundary_id boundary_id;
    };



    /// Those of a quadrilateral, a cell in the plane or a face in space, in
    /// their order around it. deal.II numbers its vertices and lines
    /// lexicographically: around it, one passes the vertices 0, 1, 3, 2 and the
    /// lines 2 (below), 1, 3, 0.
    template <int dim, typename Quadrilateral>
    std::vector<AroundQuadrilateral<dim>>
    corners_around(const Quadrilateral      &quadrilateral,
                   const UnitPositions<dim> &unit_positions)
    {
      constexpr std::array<unsigned int, 4> vertices = {{0, 1, 3, 2}};
      constexpr std::array<unsigned int, 4> lines    = {{2, 1, 3, 0}};
      std::vector<AroundQuadrilateral<dim>> around;
      const auto add = [&](const auto &object, const unsigned int v, auto id) {
        const VertexNumber n = object->vertex_dof_index(v, 0);
        around.push_back(
          {{{{n, n, n, n}}, object->vertex(v), unit_positions.at(n)}, id});
      };
      for (unsigned int i = 0; i < 4; ++i)
        {
          const auto line = quadrilateral->line(lines[i]);
          add(quadrilateral, vertices[i], line->boundary_id());
          if (line->has_children())
            add(line->child(0), 1, line->boundary_id());
        }
      return around;
    }



    std::vector<Facet<2>>
    facets_of(const DoFHandler<2>::active_cell_iterator &cell,
              const UnitPositions<2>                    &unit_positions)
    {
      std::vector<Facet<2>> facets;
      const auto            around = corners_around<2>(cell, unit_positions);
      for (unsigned int i = 0; i < around.size(); ++i)
        facets.push_back(
          {{{around[i].corner, around[(i + 1) % around.size()].corner}},
           around[i].boundary_id});
      return facets;
    }



    /// Cuts a face without children from its centre to the points around it.
    void
    add_facets(std::vector<Facet<3>>              &facets,
               const DoFHandler<3>::face_iterator &face,
               const UnitPositions<3>             &unit_positions)
    {
      FacetCorner<3> centre;
      for (unsigned int v = 0; v < 4; ++v)
        centre.key[v] = face->vertex_dof_index(v, 0);
      centre.position      = face->center();
      centre.unit_position = middle(unit_positions.at(centre.key[0]),
                                    unit_positions.at(centre.key[3]));
      std::sort(centre.key.begin(), centre.key.end());
      const auto around = corners_around<3>(face, unit_positions);
      for (unsigned int i = 0; i < around.size(); ++i)
        facets.push_back(
          {{{centre, around[i].corner, around[(i + 1) % around.size()].corner}},
           face->boundary_id()});
    }



    std::vector<Facet<3>>
    facets_of(const DoFHandler<3>::active_cell_iterator &cell,
              const UnitPositions<3>                    &unit_positions)
    {
      std::vector<Facet<3>> facets;
      for (const auto &face : cell->face_iterators())
        if (face->has_children())
          for (unsigned int c = 0; c < face->n_children(); ++c)
            add_facets(facets, face->child(c), unit_positions);
        else
          add_facets(facets, face, unit_positions);
      return facets;
    }
  } // namespace



  template <int dim>
  std::vector<CutCell<dim>>
  gather_cut_cells(const Triangulation<dim> &triangulation)
  {
    const FE_Q<dim> fe(1);
    DoFHandler<dim> dof_handler(triangulation);
    dof_handler.distribute_dofs(fe);

    std::vector<CutCell<dim>> own;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        own.push_back({cell->id(),
                       cell->material_id(),
                       cell->center(),
                       facets_of(cell, unit_positions_of<dim>(cell))});

    std::vector<CutCell<dim>> all;
    for (const auto &cells :
         Utilities::MPI::gather(communicator_of(triangulation), own))
      all.insert(all.end(), cells.begin(), cells.end());
    std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
      return a.id < b.id;
    });
    return all;
  }



  template std::vector<CutCell<2>>
  gather_cut_cells(const Triangulation<2> &);
  template std::vector<CutCell<3>>
  gather_cut_cells(const Triangulation<3> &);
} // namespace ElastoPlastic
