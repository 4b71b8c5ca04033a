// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <map>

#include "base/largest_error.h"
#include "bounds/mesh/cut_cells.h"
#include "bounds/mesh/split_mesh.h"
#include "mesh/curved_boundaries.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Puts simplices together, one after the other.
    template <int dim>
    class Assembler
    {
    public:
      void
      add(const CutCell<dim> &cell)
      {
        mesh.cells.push_back({cell.id, cell.material_id});
        const unsigned int centre = mesh.vertices.size();
        mesh.vertices.push_back(cell.centre);
        Point<dim> unit_centre;
        for (unsigned int d = 0; d < dim; ++d)
          unit_centre[d] = 0.5;
        for (const Facet<dim> &facet : cell.facets)
          {
            std::array<Corner, dim + 1> corners;
            for (unsigned int i = 0; i < dim; ++i)
              corners[i] = {vertex(facet.corners[i]),
                            facet.corners[i].unit_position};
            corners[dim] = {centre, unit_centre};
            add_simplex(corners, facet.boundary_id);
          }
      }

      SplitMesh<dim> mesh;

    private:
      unsigned int
      vertex(const FacetCorner<dim> &corner)
      {
        const auto [entry, is_new] =
          vertices.try_emplace(corner.key, mesh.vertices.size());
        if (is_new)
          mesh.vertices.push_back(corner.position);
        return entry->second;
      }

      /// A vertex of the mesh, and where it is in the unit cell.
      struct Corner
      {
        unsigned int vertex;
        Point<dim>   unit_position;
      };

      // The last of the corners is the centre of the cell. In the plane, they
      // are in positive orientation.
      void
      add_simplex(std::array<Corner, dim + 1> corners,
                  const types::boundary_id    outer_boundary)
      {
        const unsigned int centre = corners[dim].vertex;
        if (dim == 3)
          std::sort(corners.begin(),
                    corners.end(),
                    [](const Corner &a, const Corner &b) {
                      return a.vertex < b.vertex;
                    });
        typename SplitMesh<dim>::Simplex simplex;
        for (unsigned int i = 0; i <= dim; ++i)
          {
            simplex.vertices[i]     = corners[i].vertex;
            simplex.unit_corners[i] = corners[i].unit_position;
          }
        simplex.cell = mesh.cells.size() - 1;
        for (unsigned int e = 0; e < edges_per_simplex<dim>; ++e)
          {
            const auto [a, b] = ends_of_edge<dim>(e);
            simplex.edges[e]  = edge(simplex.vertices[a], simplex.vertices[b]);
          }
        for (unsigned int k = 0; k <= dim; ++k)
          {
            std::array<unsigned int, dim> ends;
            for (unsigned int i = 0; i < dim; ++i)
              ends[i] = simplex.vertices[corner_of_face<dim>(k, i)];
            simplex.faces[k] =
              face(ends,
                   simplex.vertices[opposite_corner<dim>(k)] == centre ?
                     outer_boundary :
                     numbers::internal_face_boundary_id);
          }
        mesh.simplices.push_back(simplex);
      }

      unsigned int
      edge(const unsigned int a, const unsigned int b)
      {
        const auto [entry, is_new] =
          edges.try_emplace(std::minmax(a, b), mesh.n_edges);
        if (is_new)
          ++mesh.n_edges;
        return entry->second;
      }

      unsigned int
      face(const std::array<unsigned int, dim> &corners,
           const types::boundary_id             boundary_id)
      {
        auto sorted = corners;
        std::sort(sorted.begin(), sorted.end());
        const unsigned int here = mesh.simplices.size();
        const auto [entry, is_new] =
          faces.try_emplace(sorted, mesh.faces.size());
        if (is_new)
          mesh.faces.push_back(
            {corners, boundary_id, {{here, numbers::invalid_unsigned_int}}});
        else
          mesh.faces[entry->second].neighbors[1] = here;
        return entry->second;
      }

      std::map<CutVertex, unsigned int>                             vertices;
      std::map<std::pair<unsigned int, unsigned int>, unsigned int> edges;
      std::map<std::array<unsigned int, dim>, unsigned int>         faces;
    };
  } // namespace



  template <int dim>
  std::array<unsigned int, dim>
  SplitMesh<dim>::places_in_part(const unsigned int t,
                                 const unsigned int k) const
  {
    const auto                   &face = faces[simplices[t].faces[k]];
    std::array<unsigned int, dim> places;
    for (unsigned int i = 0; i < dim; ++i)
      places[i] =
        place_in_part<dim>(k, simplices[t].place_of_vertex(face.vertices[i]));
    return places;
  }



  template <int dim>
  double
  SplitMesh<dim>::size() const
  {
    double size = 0;
    for (const auto &vertex : vertices)
      keep_largest(size, vertex.distance(vertices.front()));
    return size;
  }



  template <int dim>
  SplitMesh<dim>
  make_split_mesh(const Triangulation<dim> &triangulation)
  {
    Assembler<dim> assembler;
    for (const auto &cell : gather_cut_cells(triangulation))
      assembler.add(cell);
    return assembler.mesh;
  }



  template <int dim>
  std::string
  warning_of_curved_body(const Triangulation<dim> &triangulation)
  {
    if (!has_curved_boundary(triangulation))
      return "";
    return "The boundary of the body is curved. Its bounds are those of the " +
           std::string(dim == 2 ? "polygon" : "polyhedron") +
           " that each mesh makes of it, which lacks what is beyond its sides, "
           "and fills a part of every hole. They may exclude what holds for "
           "the body, by about as much as the bounds of two meshes differ.";
  }



  template struct SplitMesh<2>;
  template struct SplitMesh<3>;
  template SplitMesh<2>
  make_split_mesh(const Triangulation<2> &);
  template SplitMesh<3>
  make_split_mesh(const Triangulation<3> &);
  template std::string
  warning_of_curved_body(const Triangulation<2> &);
  template std::string
  warning_of_curved_body(const Triangulation<3> &);
} // namespace ElastoPlastic
