// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_curved_boundaries_h
#define mesh_curved_boundaries_h

#include <deal.II/grid/tria.h>

#include <functional>
#include <string>
#include <vector>

#include "mesh/boundary_names.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Boundary faces of a coarse mesh that lie on one smooth surface (2D: curve)
  /// of the body.
  template <int dim>
  struct BoundarySurface
  {
    types::boundary_id                                      boundary;
    std::vector<typename Triangulation<dim>::face_iterator> faces;
  };



  /// Lets refinement follow the circles (2D), spheres and circular cylinders
  /// (3D) that the vertices of a whole surface lie on, within 1e-6 of the
  /// radius. A surface must have more than one face, and faces that are not
  /// longer than the radius: the corners of a square lie on a circle, too.
  ///
  /// @p warn is told about boundaries (@p names) with a surface that bends
  /// smoothly and is none of these; and if the cells beside a curve are so thin
  /// that they would turn over, whereupon nothing is followed.
  template <int dim>
  void
  follow_curved_boundaries(const std::vector<BoundarySurface<dim>> &surfaces,
                           const BoundaryNames                     &names,
                           const std::function<void(const std::string &)> &warn,
                           Triangulation<dim> &mesh);

  /// Whether refinement changes the body: a part of its boundary follows a
  /// curve or a curved surface.
  template <int dim>
  bool
  has_curved_boundary(const Triangulation<dim> &mesh);
} // namespace ElastoPlastic

#endif
