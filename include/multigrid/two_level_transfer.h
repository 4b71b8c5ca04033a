// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef multigrid_two_level_transfer_h
#define multigrid_two_level_transfer_h

#include <deal.II/distributed/tria.h>

#include "base/nodal_interpolation.h"
#include "multigrid/level_operator.h"

namespace ElastoPlastic
{
  /// What two adjacent levels of multigrid hand to each other: corrections from
  /// the coarse to the fine one by interpolation, residuals back by its
  /// transpose, and data of nodes and cells.
  ///
  /// The interpolation is stored as a sparse matrix in single precision, with
  /// one row for all unknowns of a node, with the constraints of the coarse
  /// level (hanging nodes, skew rollers) already resolved and without rows for
  /// the eliminated unknowns of the fine one: 3.4 entries per row for trilinear
  /// elements on a uniform mesh. The two levels may be partitioned in different
  /// ways.
  ///
  /// (deal.II's MGTwoLevelTransfer finds out who needs what with a table of all
  /// cells that there would be if the mesh were uniformly fine. Local
  /// refinement makes that larger than the memory, and than 32 bits.)
  template <int dim>
  class TwoLevelTransfer
  {
  public:
    using Constraints = AffineConstraints<double>;

    /// The meshes of both are the same (the coarse one with elements of lower
    /// degree) or neighbours in a mesh_sequence().
    TwoLevelTransfer(const DoFHandler<dim> &fine,
                     const Constraints     &fine_constraints,
                     const DoFHandler<dim> &coarse,
                     const Constraints     &coarse_constraints);

    void
    prolongate_and_add(LevelVector &fine, const LevelVector &coarse) const;

    void
    restrict_and_add(LevelVector &coarse, const LevelVector &fine) const;

    /// Sets the unconstrained entries of @p coarse to those of the fine nodes
    /// at the same places.
    void
    inject(LevelVector &coarse, const LevelVector &fine) const;

    /// Sets each entry of @p coarse to the mean of the fine cells in the coarse
    /// one. Both have one entry for each locally owned cell.
    void
    average_cells(LevelVector &coarse, const LevelVector &fine) const;

  private:
    /// Of the fine unknowns from coarse_values, in local indices.
    NodalInterpolation<dim, float> interpolation;

    struct Parent
    {
      unsigned int index; // in coarse_cell_values
      float        share;
    };

    /// For each fine cell, the coarse one, and its share in that.
    std::vector<Parent> parents;

    /// Coarse entries, with the ghosts that the matrices need.
    mutable LevelVector coarse_values;
    mutable LevelVector coarse_cell_values;
  };
} // namespace ElastoPlastic

#endif
