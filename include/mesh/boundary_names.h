// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_boundary_names_h
#define mesh_boundary_names_h

#include <deal.II/base/types.h>

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
} // namespace ElastoPlastic

#endif
