// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <set>
#include <vector>

#include "mesh/gmsh_boundaries.h"

namespace ElastoPlastic
{
  template <int dim>
  GmshBoundaries<dim>::GmshBoundaries(
    const GmshContents                             &contents,
    const GmshCoarseMesh<dim>                      &mesh,
    const std::function<void(const std::string &)> &warn,
    Triangulation<dim>                             &triangulation)
    : contents(contents)
    , has_groups(std::any_of(contents.elements.begin(),
                             contents.elements.end(),
                             [](const auto &element) {
                               return element.type ==
                                        GmshCoarseMesh<dim>::face_type &&
                                      element.physical_tag != 0;
                             }))
  {
    const auto parts = parts_of_faces(mesh);
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            const auto     found = parts.find(mesh.vertices_of(face));
            const FacePart part =
              found == parts.end() ? FacePart(0, 0) : found->second;
            face->set_all_boundary_ids(part.first);
            faces[part].boundary = part.first;
            faces[part].faces.push_back(face);
          }
    if (faces.empty() || faces.rbegin()->first.first == 0)
      contents.reject(
        "no part of its boundary is in a physical group. In Gmsh, put the "
        "parts of the boundary into physical curves (2D) or surfaces (3D) with "
        "names.");
    if (!has_groups)
      warn(
        "No part of the boundary of the mesh file is in a physical group, so "
        "its parts are called by the numbers of Gmsh's curves (2D) or "
        "surfaces (3D): " +
        list_of_names(names()) + ".");
  }



  template <int dim>
  std::map<typename GmshCoarseMesh<dim>::Vertices,
           typename GmshBoundaries<dim>::FacePart>
  GmshBoundaries<dim>::parts_of_faces(const GmshCoarseMesh<dim> &mesh) const
  {
    std::map<typename GmshCoarseMesh<dim>::Vertices, FacePart> parts;
    for (const auto &element : contents.elements)
      {
        const unsigned int number =
          has_groups ? element.physical_tag : element.entity;
        if (element.type != GmshCoarseMesh<dim>::face_type || number == 0)
          continue;
        const auto [part, is_new] =
          parts.emplace(mesh.vertices_of(element.nodes),
                        FacePart(number, element.entity));
        if (!is_new && part->second.first != number)
          contents.reject("a face of the mesh is in the groups '" +
                          contents.group_name(dim - 1, number) + "' and '" +
                          contents.group_name(dim - 1, part->second.first) +
                          "', but one is allowed.");
      }
    return parts;
  }



  template <int dim>
  BoundaryNames
  GmshBoundaries<dim>::names() const
  {
    std::set<types::boundary_id> ids;
    for (const auto &[part, surface] : faces)
      ids.insert(part.first);
    BoundaryNames result;
    for (const types::boundary_id id : ids)
      {
        const std::string name =
          has_groups ? contents.group_name(dim - 1, id) : std::to_string(id);
        if (name.find_first_of(",|#") != std::string::npos)
          contents.reject("the boundary name '" + name +
                          "' in it contains a character of ',|#', which "
                          "'Boundary conditions' cannot hold. Give the "
                          "physical group another name in Gmsh.");
        if (!result.emplace(name, id).second)
          contents.reject(
            "two physical groups on the boundary have the name '" + name +
            "'.");
      }
    return result;
  }



  template <int dim>
  std::vector<BoundarySurface<dim>>
  GmshBoundaries<dim>::surfaces() const
  {
    std::vector<BoundarySurface<dim>> result;
    for (const auto &[part, surface] : faces)
      if (part.first != 0)
        result.push_back(surface);
    return result;
  }



  template class GmshBoundaries<2>;
  template class GmshBoundaries<3>;
} // namespace ElastoPlastic
