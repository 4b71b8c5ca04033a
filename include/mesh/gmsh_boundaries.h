// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_gmsh_boundaries_h
#define mesh_gmsh_boundaries_h

#include <functional>
#include <map>
#include <string>
#include <utility>

#include "mesh/boundary_names.h"
#include "mesh/curved_boundaries.h"
#include "mesh/gmsh_coarse_mesh.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The boundary of a mesh file, divided by its physical groups or, if no face
  /// of it is in one, by the curves (2D) or surfaces (3D) of Gmsh's geometry.
  template <int dim>
  class GmshBoundaries
  {
  public:
    /// Gives each boundary face of @p triangulation, which @p mesh has made,
    /// the number of its part, 0 for what is in none. @p warn is told if there
    /// are no groups.
    /// @throws InputError if there is neither a group nor a curve or surface,
    /// or if a face is in two groups.
    GmshBoundaries(const GmshContents                             &contents,
                   const GmshCoarseMesh<dim>                      &mesh,
                   const std::function<void(const std::string &)> &warn,
                   Triangulation<dim> &triangulation);

    /// @throws InputError if two parts have the same name, or if one cannot be
    /// an entry of a parameter file.
    BoundaryNames
    names() const;

    /// The faces by part and geometric entity, without those in no part.
    std::vector<BoundarySurface<dim>>
    surfaces() const;

  private:
    /// The number of a part, and of the geometric entity.
    using FacePart = std::pair<unsigned int, long>;

    std::map<typename GmshCoarseMesh<dim>::Vertices, FacePart>
    parts_of_faces(const GmshCoarseMesh<dim> &mesh) const;

    const GmshContents                      &contents;
    bool                                     has_groups;
    std::map<FacePart, BoundarySurface<dim>> faces;
  };
} // namespace ElastoPlastic

#endif
