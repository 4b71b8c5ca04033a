// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_boundary_names_h
#define mesh_boundary_names_h

#include <deal.II/base/types.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <string>

namespace ElastoPlastic
{
  using namespace dealii;



  /// The parts of the boundary of a mesh: what a user calls them, and their
  /// boundary id in the triangulation.
  using BoundaryNames = std::map<std::string, types::boundary_id>;

  /// "bottom, left, top", for messages.
  inline std::string
  list_of_names(const BoundaryNames &names)
  {
    std::string list;
    for (const auto &[name, id] : names)
      list += (list.empty() ? "" : ", ") + name;
    return list;
  }



  /// Makes parts of boundaries boundaries of their own, with conditions of
  /// their own: "surcharge: top; x > 1" calls those faces of "top" "surcharge"
  /// on which the expression is not zero. Parts are separated by '|', and each
  /// takes from what those before it have left. Faces of a @p coarse_mesh
  /// belong to a part wholly or not at all, and faces into which they are
  /// divided later with them.
  ///
  /// @p text is the value of the entry @p path. Adds the new names and ids.
  /// @throws InputError if it is not of this form, names no boundary or one
  /// that exists already, or if a part is empty, all of the boundary, or ends
  /// within a face.
  template <int dim>
  void
  name_boundary_parts(const std::string  &path,
                      const std::string  &text,
                      Triangulation<dim> &coarse_mesh,
                      BoundaryNames      &names);
} // namespace ElastoPlastic

#endif
