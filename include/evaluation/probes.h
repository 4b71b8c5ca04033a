// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_probes_h
#define evaluation_probes_h

#include <deal.II/distributed/tria.h>

#include <optional>
#include <string>
#include <vector>

#include "loads/loaded_body.h"
#include "mechanics/solid_operator.h"
#include "mesh/boundary_names.h"

namespace ElastoPlastic
{
  /// Points of the undeformed body whose displacement, stress and strain are
  /// written at the end of each load step. Stress and strain are those of one
  /// cell, continued from its quadrature points as in the fields (BodyOutput);
  /// of several cells that meet at a point, it is the first in the order of
  /// their ids, whatever the number of ranks.
  template <int dim>
  class ProbePoints
  {
  public:
    /// @p text is the entry Output/Probe points, such as
    /// "root: 0, 1.5 | end: 4, 2"; @p boundaries have names, too. Collective.
    /// @throws InputError, also if a point lies outside the body
    ProbePoints(const std::string                               &text,
                const BoundaryNames                             &boundaries,
                const parallel::distributed::Triangulation<dim> &triangulation);

    /// "root_displacement_x", ..., "root_stress_xx", ..., "root_strain_xx",
    /// ..., "root_equivalent_plastic_strain" for each point.
    std::vector<std::string>
    names() const;

    /// The values for the displacement @p u, in the order of names(), on all
    /// ranks. Collective. @throws InputError if a point lies outside a mesh
    /// that has been refined.
    std::vector<double>
    compute(const DoFHandler<dim>    &dof_handler,
            const SolidOperator<dim> &solid,
            const VectorType         &u) const;

  private:
    struct Probe
    {
      std::string name;
      Point<dim>  point;
    };

    /// A place in a cell of this rank.
    struct Place
    {
      typename Triangulation<dim>::active_cell_iterator cell;
      Point<dim>                                        unit_point;
    };

    Probe
    read(const std::string &text) const;

    /// Where the probes are: on exactly one rank each. Collective.
    /// @throws InputError
    std::vector<std::optional<Place>>
    locate(const double widest) const;

    /// @throws InputError, collectively.
    [[noreturn]] void
    report_outside(const Probe &probe) const;

    const parallel::distributed::Triangulation<dim> &triangulation;
    std::vector<Probe>                               probes;
  };



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
