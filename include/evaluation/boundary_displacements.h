// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_boundary_displacements_h
#define evaluation_boundary_displacements_h

#include <deal.II/distributed/tria.h>

#include <string>
#include <vector>

#include "loads/loaded_body.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  /// The mean displacements of all boundaries, weighted with the area, that of
  /// whole rings in an axisymmetric body. The axis of revolution, which has no
  /// area, is left out.
  template <int dim>
  class BoundaryDisplacements
  {
  public:
    /// Collective.
    BoundaryDisplacements(
      const LoadedBody<dim>                           &body,
      const parallel::distributed::Triangulation<dim> &triangulation);

    /// "top_displacement_x", ..., boundary by boundary.
    std::vector<std::string>
    names() const;

    /// The means of @p u, in the order of names(), on all ranks. Collective.
    std::vector<double>
    compute(const DoFHandler<dim> &dof_handler, const VectorType &u) const;

  private:
    const Kinematics kinematics;
    BoundaryNames    boundaries;
  };
} // namespace ElastoPlastic

#endif
