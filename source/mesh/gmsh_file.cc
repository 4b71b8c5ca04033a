// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "base/exceptions.h"
#include "mesh/gmsh_contents.h"
#include "mesh/gmsh_file.h"
#include "mesh/hanging_vertex.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr unsigned int quadrilateral = 3, hexahedron = 5;

    template <int dim>
    constexpr unsigned int cell_type = (dim == 2 ? quadrilateral : hexahedron);

    template <int dim>
    constexpr unsigned int face_type = (dim == 2 ? 1 : quadrilateral);



    [[noreturn]] void
    reject(const std::string &file, const std::string &reason)
    {
      throw InputError("Geometry/File", file, reason);
    }



    unsigned int
    n_elements(const GmshContents &contents, const unsigned int type)
    {
      return std::count_if(contents.elements.begin(),
                           contents.elements.end(),
                           [type](const auto &element) {
                             return element.type == type;
                           });
    }



    template <int dim>
    void
    check_mesh(const std::string &file, const GmshContents &contents)
    {
      const unsigned int n_quadrilaterals = n_elements(contents, quadrilateral);
      const unsigned int n_hexahedra      = n_elements(contents, hexahedron);
      if (n_quadrilaterals + n_hexahedra == 0)
        reject(file,
               "this file has no cells. Save the volumes (2D: surfaces) as "
               "well, for instance as a physical group.");
      if (dim == 2 && n_hexahedra > 0)
        reject(file,
               "this mesh is three-dimensional (hexahedra), while 'Dimension' "
               "is 2.");
      if (dim == 3 && n_hexahedra == 0)
        reject(file,
               "this mesh is two-dimensional (quadrilaterals only), while "
               "'Dimension' is 3.");
      if (const BoundingBox<3> box(contents.nodes);
          dim == 2 && box.side_length(2) > 1e-10 * box.side_length(0))
        reject(file,
               "this mesh does not lie in a plane z = const, while 'Dimension' "
               "is 2.");
    }



    /// The nodes that cells use, and the cells that use them, as deal.II wants
    /// them.
    template <int dim>
    struct CoarseMesh
    {
      explicit CoarseMesh(const GmshContents &contents)
      {
        for (const auto &element : contents.elements)
          if (element.type == cell_type<dim>)
            add_cell(element, contents.nodes);
      }

      /// Gmsh numbers the nodes of a cell around, deal.II lexicographically.
      void
      add_cell(const GmshContents::Element &element,
               const std::vector<Point<3>> &nodes)
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
                std::copy_n(nodes[node].begin_raw(),
                            dim,
                            vertices.back().begin_raw());
              }
            cells.back().vertices[GeometryInfo<dim>::ucd_to_deal[i]] =
              vertex->second;
          }
      }

      std::map<unsigned int, unsigned int> vertex_of_node;
      std::vector<Point<dim>>              vertices;
      std::vector<CellData<dim>>           cells;
    };



    /// The numbers in increasing order, by which a face can be recognised.
    std::vector<unsigned int>
    sorted(std::vector<unsigned int> vertices)
    {
      std::sort(vertices.begin(), vertices.end());
      return vertices;
    }



    /// deal.II relies on at most two cells meeting at a face.
    template <int dim>
    void
    check_faces(const std::string &file, const CoarseMesh<dim> &mesh)
    {
      using Info = GeometryInfo<dim>;
      std::map<std::vector<unsigned int>, unsigned int> n_cells_at_face;
      for (const auto &cell : mesh.cells)
        for (const unsigned int f : Info::face_indices())
          {
            std::vector<unsigned int> face(Info::vertices_per_face);
            for (unsigned int v = 0; v < face.size(); ++v)
              face[v] = cell.vertices[Info::face_to_cell_vertices(f, v)];
            if (++n_cells_at_face[sorted(face)] > 2)
              {
                std::ostringstream corner;
                corner << mesh.vertices[face.front()];
                reject(file,
                       "more than two cells meet at a face with the corner (" +
                         corner.str() + "): some of them overlap.");
              }
          }
    }



    template <int dim>
    void
    create_mesh(const std::string  &file,
                CoarseMesh<dim>    &mesh,
                Triangulation<dim> &triangulation)
    {
      try
        {
          GridTools::invert_cells_with_negative_measure(mesh.vertices,
                                                        mesh.cells);
          GridTools::consistently_order_cells(mesh.cells);
          triangulation.create_triangulation(mesh.vertices,
                                             mesh.cells,
                                             SubCellData());
        }
      catch (const typename Triangulation<dim>::DistortedCellList &distorted)
        {
          reject(file,
                 std::to_string(distorted.distorted_cells.size()) +
                   " cells of this mesh are distorted (degenerate or turned "
                   "over at a corner).");
        }
      catch (const ExceptionBase &exception)
        {
          std::ostringstream reason;
          exception.print_info(reason);
          reject(file,
                 "its cells do not fit together; are there degenerate or "
                 "overlapping ones? deal.II says: " +
                   Utilities::trim(reason.str()));
        }
      if (const auto vertex = find_hanging_vertex(triangulation))
        {
          std::ostringstream corner;
          corner << *vertex;
          reject(file,
                 "the corner (" + corner.str() +
                   ") of a cell lies inside an edge of another one. Cells must "
                   "meet at whole faces; smaller ones beside larger ones are "
                   "made by 'Local refinements' and 'Refinement'.");
        }
    }



    /// The physical groups of faces, which are found by their vertices.
    template <int dim>
    std::map<std::vector<unsigned int>, unsigned int>
    groups_of_faces(const GmshContents &contents, const CoarseMesh<dim> &mesh)
    {
      std::map<std::vector<unsigned int>, unsigned int> groups;
      for (const auto &element : contents.elements)
        if (element.type == face_type<dim> && element.physical_tag != 0)
          {
            std::vector<unsigned int> vertices;
            for (const unsigned int node : element.nodes)
              if (const auto vertex = mesh.vertex_of_node.find(node);
                  vertex != mesh.vertex_of_node.end())
                vertices.push_back(vertex->second);
            groups[sorted(vertices)] = element.physical_tag;
          }
      return groups;
    }



    /// Give each boundary face the number of its group, or 0.
    /// @return the numbers there are.
    template <int dim>
    std::set<types::boundary_id>
    set_boundary_ids(
      const std::map<std::vector<unsigned int>, unsigned int> &groups,
      Triangulation<dim>                                      &triangulation)
    {
      std::set<types::boundary_id> ids;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            {
              std::vector<unsigned int> vertices;
              for (const unsigned int v : face->vertex_indices())
                vertices.push_back(face->vertex_index(v));
              const auto group = groups.find(sorted(vertices));
              face->set_all_boundary_ids(group == groups.end() ? 0 :
                                                                 group->second);
              ids.insert(face->boundary_id());
            }
      return ids;
    }



    BoundaryNames
    name_boundaries(const std::string                  &file,
                    const std::set<types::boundary_id> &ids,
                    const GmshContents                 &contents,
                    const unsigned int                  dim)
    {
      BoundaryNames names;
      for (const types::boundary_id id : ids)
        {
          const auto        found = contents.physical_names.find({dim - 1, id});
          const std::string name  = found == contents.physical_names.end() ?
                                      std::to_string(id) :
                                      found->second;
          if (name.find_first_of(",;:|") != std::string::npos)
            reject(file,
                   "the boundary name '" + name +
                     "' in it contains a character of ',;:|', which separate "
                     "names in 'Boundary conditions'.");
          if (!names.emplace(name, id).second)
            reject(file,
                   "two physical groups on the boundary have the name '" +
                     name + "'.");
        }
      return names;
    }
  } // namespace



  void
  GmshFileParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "File",
      file,
      "Type file: a mesh that Gmsh has written, ASCII format 2.2 or 4.1, of "
      "quadrilaterals (2D) or hexahedra (3D) of first order. Physical curves "
      "(2D) or surfaces (3D) become boundaries, called by their name or, if "
      "they have none, by their number; the part in no group is called 0. "
      "Physical surfaces or volumes give the material ids. A relative name "
      "starts in the folder of the parameter file.",
      Patterns::Anything());
  }



  void
  GmshFileParameters::check(const unsigned int dim) const
  {
    const GmshContents contents(file);
    if (dim == 2)
      check_mesh<2>(file, contents);
    else
      check_mesh<3>(file, contents);
  }



  template <int dim>
  BoundaryNames
  make_mesh_from_gmsh_file(const GmshFileParameters &parameters,
                           Triangulation<dim>       &triangulation)
  {
    const std::string &file = parameters.file;
    const GmshContents contents(file);
    check_mesh<dim>(file, contents);

    CoarseMesh<dim> mesh(contents);
    check_faces(file, mesh);
    create_mesh(file, mesh, triangulation);
    const auto ids =
      set_boundary_ids(groups_of_faces(contents, mesh), triangulation);
    if (ids.empty() || *ids.rbegin() == 0)
      reject(file,
             "no part of its boundary is in a physical group. In Gmsh, put "
             "the parts of the boundary into physical curves (2D) or surfaces "
             "(3D) with names.");
    return name_boundaries(file, ids, contents, dim);
  }



  template BoundaryNames
  make_mesh_from_gmsh_file(const GmshFileParameters &, Triangulation<2> &);
  template BoundaryNames
  make_mesh_from_gmsh_file(const GmshFileParameters &, Triangulation<3> &);
} // namespace ElastoPlastic
