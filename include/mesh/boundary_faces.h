// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_boundary_faces_h
#define mesh_boundary_faces_h

#include <deal.II/base/types.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Faces of a Triangulation or a DoFHandler, each as its cell and its number
  /// there.
  template <typename Mesh>
  using Faces =
    std::vector<std::pair<typename Mesh::active_cell_iterator, unsigned int>>;

  /// Those of @p boundaries, at the cells of this rank and at ghost cells.
  template <typename Mesh>
  Faces<Mesh>
  known_faces(const Mesh &mesh, const std::set<types::boundary_id> &boundaries)
  {
    Faces<Mesh> faces;
    for (const auto &cell : mesh.active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              boundaries.count(cell->face(f)->boundary_id()) > 0)
            faces.emplace_back(cell, f);
    return faces;
  }



  /// Those at the cells of this rank.
  template <typename Mesh>
  Faces<Mesh>
  owned_faces(const Mesh &mesh, const std::set<types::boundary_id> &boundaries)
  {
    Faces<Mesh> faces = known_faces(mesh, boundaries);
    faces.erase(std::remove_if(faces.begin(),
                               faces.end(),
                               [](const auto &face) {
                                 return !face.first->is_locally_owned();
                               }),
                faces.end());
    return faces;
  }
} // namespace ElastoPlastic

#endif
