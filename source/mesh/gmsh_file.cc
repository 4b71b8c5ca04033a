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
#include "mesh/curved_boundaries.h"
#include "mesh/gmsh_contents.h"
#include "mesh/gmsh_file.h"
#include "mesh/mesh_defects.h"

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
        original_vertices = separate_pinched_vertices(vertices, cells);
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
      std::vector<unsigned int> original_vertices; ///< those of the nodes
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



    /// The physical group and the geometric entity that a face belongs to.
    using FaceGroup = std::pair<unsigned int, long>;



    /// The groups of faces, which are found by the vertices of their nodes.
    template <int dim>
    std::map<std::vector<unsigned int>, FaceGroup>
    groups_of_faces(const GmshContents &contents, const CoarseMesh<dim> &mesh)
    {
      std::map<std::vector<unsigned int>, FaceGroup> groups;
      for (const auto &element : contents.elements)
        if (element.type == face_type<dim> && element.physical_tag != 0)
          {
            std::vector<unsigned int> vertices;
            for (const unsigned int node : element.nodes)
              if (const auto vertex = mesh.vertex_of_node.find(node);
                  vertex != mesh.vertex_of_node.end())
                vertices.push_back(vertex->second);
            groups[sorted(vertices)] = {element.physical_tag, element.entity};
          }
      return groups;
    }



    /// Give each boundary face the number of its group, or 0.
    /// @return the faces by group and entity.
    template <int dim>
    std::map<FaceGroup, BoundarySurface<dim>>
    set_boundary_ids(
      const std::map<std::vector<unsigned int>, FaceGroup> &groups,
      const std::vector<unsigned int>                      &original_vertices,
      Triangulation<dim>                                   &triangulation)
    {
      std::map<FaceGroup, BoundarySurface<dim>> surfaces;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            {
              std::vector<unsigned int> vertices;
              for (const unsigned int v : face->vertex_indices())
                vertices.push_back(original_vertices[face->vertex_index(v)]);
              const auto      found = groups.find(sorted(vertices));
              const FaceGroup group =
                found == groups.end() ? FaceGroup(0, 0) : found->second;
              face->set_all_boundary_ids(group.first);
              surfaces[group].boundary = group.first;
              surfaces[group].faces.push_back(face);
            }
      return surfaces;
    }



    template <int dim>
    BoundaryNames
    name_boundaries(const std::string                               &file,
                    const std::map<FaceGroup, BoundarySurface<dim>> &surfaces,
                    const GmshContents                              &contents)
    {
      std::set<types::boundary_id> ids;
      for (const auto &[group, surface] : surfaces)
        ids.insert(surface.boundary);
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
    prm.add_parameter(
      "Curves",
      curves,
      "Type file: followed: refinement follows the circles (2D), spheres "
      "and circular cylinders (3D) that the vertices of a curve or surface "
      "of the geometry lie on, if there are at least two faces of the mesh "
      "on it; only boundaries in physical groups are looked at. straight: "
      "the boundary remains that of the mesh in the file.");
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
                           const std::function<void(const std::string &)> &warn,
                           Triangulation<dim> &triangulation)
  {
    const std::string &file = parameters.file;
    const GmshContents contents(file);
    check_mesh<dim>(file, contents);

    CoarseMesh<dim> mesh(contents);
    check_faces(file, mesh);
    create_mesh(file, mesh, triangulation);
    const auto surfaces = set_boundary_ids(groups_of_faces(contents, mesh),
                                           mesh.original_vertices,
                                           triangulation);
    if (surfaces.empty() || surfaces.rbegin()->second.boundary == 0)
      reject(file,
             "no part of its boundary is in a physical group. In Gmsh, put "
             "the parts of the boundary into physical curves (2D) or surfaces "
             "(3D) with names.");
    const BoundaryNames names = name_boundaries(file, surfaces, contents);
    if (parameters.curves == Curves::followed)
      {
        std::vector<BoundarySurface<dim>> named_surfaces;
        for (const auto &[group, surface] : surfaces)
          if (surface.boundary != 0)
            named_surfaces.push_back(surface);
        follow_curved_boundaries(named_surfaces, names, warn, triangulation);
      }
    return names;
  }



  template BoundaryNames
  make_mesh_from_gmsh_file(const GmshFileParameters &,
                           const std::function<void(const std::string &)> &,
                           Triangulation<2> &);
  template BoundaryNames
  make_mesh_from_gmsh_file(const GmshFileParameters &,
                           const std::function<void(const std::string &)> &,
                           Triangulation<3> &);
} // namespace ElastoPlastic
