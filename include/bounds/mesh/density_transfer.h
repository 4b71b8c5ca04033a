// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mesh_density_transfer_h
#define bounds_mesh_density_transfer_h

#include <map>
#include <vector>

#include "bounds/mesh/split_mesh.h"

namespace ElastoPlastic
{
  /// What simplices have in proportion to their volume, carried over to a
  /// refinement or coarsening of their mesh: a simplex there has the density of
  /// the cell that it lies in, or of those that have been put together to its
  /// own.
  template <int dim>
  class DensityTransfer
  {
  public:
    /// For values @p of_simplices of a @p mesh, which need not live on.
    DensityTransfer(const SplitMesh<dim>      &mesh,
                    const std::vector<double> &of_simplices);

    /// By simplices of @p mesh; empty if the values were.
    std::vector<double>
    on(const SplitMesh<dim> &mesh) const;

  private:
    struct Sum
    {
      double value  = 0;
      double volume = 0;

      void
      operator+=(const Sum &other)
      {
        value += other.value;
        volume += other.volume;
      }
    };

    /// Of the cells of the mesh and of all those that these are parts of.
    std::map<CellId, Sum> sums;
  };
} // namespace ElastoPlastic

#endif
