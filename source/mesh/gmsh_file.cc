// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/patterns.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <set>

#include "base/exceptions.h"
#include "mesh/curved_boundaries.h"
#include "mesh/gmsh_boundaries.h"
#include "mesh/gmsh_coarse_mesh.h"
#include "mesh/gmsh_contents.h"
#include "mesh/gmsh_file.h"
#include "mesh/mesh_defects.h"

namespace ElastoPlastic
{
  namespace
  {
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
    check_mesh(const GmshContents &contents)
    {
      using Mesh = GmshCoarseMesh<dim>;
      const unsigned int n_quadrilaterals =
        n_elements(contents, Mesh::quadrilateral);
      const unsigned int n_hexahedra = n_elements(contents, Mesh::hexahedron);
      if (n_quadrilaterals + n_hexahedra == 0)
        contents.reject(
          "this file has no cells. Save the volumes (2D: surfaces) as well, for "
          "instance as a physical group.");
      if (dim == 2 && n_hexahedra > 0)
        contents.reject(
          "this mesh is three-dimensional (hexahedra), while "
          "'Dimension' is 2.");
      if (dim == 3 && n_hexahedra == 0)
        contents.reject(
          "this mesh is two-dimensional (quadrilaterals only), "
          "while 'Dimension' is 3.");
      if (const BoundingBox<3> box(contents.nodes);
          dim == 2 && box.side_length(2) > 1e-10 * box.side_length(0))
        contents.reject(
          "this mesh does not lie in a plane z = const, while "
          "'Dimension' is 2.");
    }



    /// The places in the list @p groups as material ids, instead of the numbers
    /// of the physical groups.
    template <int dim>
    void
    number_materials(const std::vector<std::string> &groups,
                     const GmshContents             &contents,
                     Triangulation<dim>             &triangulation)
    {
      const std::string     path = "Geometry/Material groups";
      std::set<std::string> names;
      for (const auto &cell : triangulation.active_cell_iterators())
        {
          const std::string name =
            contents.group_name(dim, cell->material_id());
          const auto place = std::find(groups.begin(), groups.end(), name);
          names.insert(name);
          cell->set_material_id(place - groups.begin());
        }
      const std::string all_names =
        " The cells of the mesh file are in the physical groups: " +
        boost::algorithm::join(names, ", ") + ".";
      for (auto name = groups.begin(); name != groups.end(); ++name)
        {
          if (std::find(groups.begin(), name, *name) != name)
            throw InputError(path, *name, "it stands twice in this list.");
          if (names.erase(*name) == 0)
            throw InputError(path,
                             *name,
                             "no cell is in a physical group of this name." +
                               all_names);
        }
      if (!names.empty())
        throw InputError(path,
                         groups,
                         "it must name all groups: " +
                           boost::algorithm::join(names, ", ") +
                           " is missing." + all_names);
    }
  } // namespace



  void
  GmshFileParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "File",
      file,
      "Type file: a mesh that Gmsh has written, ASCII format 2.1, 2.2 or 4.1, "
      "of quadrilaterals (2D) or hexahedra (3D); of elements of second order, "
      "the corners are read. Physical curves (2D) or surfaces (3D) become "
      "boundaries, called by their name or, if they have none, by their "
      "number; the part in no group is called 0. Without any such group, the "
      "curves or surfaces of the geometry are the boundaries, called by their "
      "numbers. A relative name starts in the folder of the parameter file.",
      Patterns::Anything());
    prm.add_parameter(
      "Material groups",
      material_groups,
      "Type file: the physical surfaces (2D) or volumes (3D) of the mesh file "
      "in the order of the values in 'Material', for instance: steel, copper. "
      "A group without a name is called by its number, the cells in none 0. "
      "Empty: the number of its group is the material id of a cell, so that "
      "the first value in 'Material' is for the cells in none.",
      Patterns::List(Patterns::Anything()));
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
      check_mesh<2>(contents);
    else
      check_mesh<3>(contents);
  }



  template <int dim>
  BoundaryNames
  make_mesh_from_gmsh_file(const GmshFileParameters &parameters,
                           const std::function<void(const std::string &)> &warn,
                           Triangulation<dim> &triangulation)
  {
    const GmshContents contents(parameters.file);
    check_mesh<dim>(contents);
    if (contents.is_of_second_order)
      warn(
        "The mesh file has elements of second order. Only their corners are "
        "read; with 'Curves = followed', refinement makes circles, spheres "
        "and cylinders round.");

    GmshCoarseMesh<dim> mesh(contents);
    mesh.create(triangulation);
    if (const auto slit = find_slit(triangulation))
      warn(
        "The body of the mesh file has a slit at (" +
        Patterns::Tools::to_string(*slit) +
        "): two boundary faces are in the same place. They are not connected, "
        "and do not touch: one side may sink into the other. If it is no "
        "crack, the nodes have been written twice: in Gmsh, 'Coherence Mesh' "
        "or 'BooleanFragments' before meshing joins the parts.");
    const GmshBoundaries<dim> boundaries(contents, mesh, warn, triangulation);
    const BoundaryNames       names = boundaries.names();
    if (!parameters.material_groups.empty())
      number_materials(parameters.material_groups, contents, triangulation);
    if (parameters.curves == Curves::followed)
      follow_curved_boundaries(boundaries.surfaces(),
                               names,
                               warn,
                               triangulation);
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
