// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_sector_h
#define mesh_sector_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include "mesh/boundary_names.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Geometry" that shape a sector of a round
  /// block.
  struct SectorParameters
  {
    double radius      = 1;
    double height      = 1;
    double angle       = 45; ///< in degrees
    double core_radius = 0.125;

    /// Declare the entries in the current section, where the half ball has
    /// declared its radius, which is this one, too.
    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError for the first value that is not allowed.
    void
    check(const unsigned int dim) const;
  };

  /// Fill @p triangulation, in three dimensions, with the coarse mesh of a
  /// sector of a cylinder: the axis is z, the top lies at z = 0, and the sides
  /// are the half-planes at the angle 0 (y = 0, x > 0) and at the given angle,
  /// counter-clockwise seen from above.
  ///
  /// Hexahedra without hanging nodes, graded towards the point where the axis
  /// meets the top: a core, and shells around and below it, each about twice as
  /// large as the one inside, of the same number of cells each. Seen from
  /// above, three quadrilaterals fill the angle at the axis (six, if it is
  /// larger than 100 degrees) and twice two thirds of them a ring.
  ///
  /// Its boundaries are top, bottom, side (the cylinder), front (y = 0) and
  /// back, which at 180 degrees is a part of front. Refinement follows the
  /// cylinder; all other edges are straight.
  template <int dim>
  BoundaryNames
  make_sector(const SectorParameters &parameters,
              Triangulation<dim>     &triangulation);
} // namespace ElastoPlastic

#endif
