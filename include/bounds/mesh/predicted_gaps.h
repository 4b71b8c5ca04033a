// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mesh_predicted_gaps_h
#define bounds_mesh_predicted_gaps_h

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <map>
#include <vector>

#include "bounds/mesh/split_mesh.h"

namespace ElastoPlastic
{
  /// How much each cell adds to the gap between two bounds: on the mesh on
  /// which they have been computed, and, as a prediction, on finer ones. With
  /// it, a mesh is refined several times before the next bounds are computed.
  ///
  /// A cell that is refined is taken to keep half of its gap, as at the edge of
  /// a punch, where the gap is proportional to the size of the cells. Each of
  /// its children gets a share in proportion to the square of the density of
  /// gaps, interpolated to its centre from the corners of the cell. Bounds hold
  /// on any mesh: a wrong prediction costs time, and nothing else.
  template <int dim>
  class PredictedGaps
  {
  public:
    /// Of the indicators, relative. Those of cells that mirror each other have
    /// differed by up to 3e-4, because an iteration ends at a tolerance.
    static constexpr double accuracy = 1e-3;

    /// For what the first rank knows of the simplices of @p mesh,
    /// @p of_simplices; negative numbers count as zero. Collective.
    PredictedGaps(const SplitMesh<dim>      &mesh,
                  const std::vector<double> &of_simplices,
                  const MPI_Comm             communicator);

    /// What decides on the refinement of the cells of @p triangulation, a
    /// refinement of the mesh above: the square roots of the gaps of the active
    /// cells of this rank.
    Vector<float>
    indicators(const Triangulation<dim> &triangulation) const;

  private:
    static constexpr unsigned int n_corners =
      GeometryInfo<dim>::vertices_per_cell;

    /// Of a cell.
    struct Gap
    {
      double                        value = 0;
      std::array<double, n_corners> densities{}; ///< at the corners

      /// At a point of the unit cell.
      double
      density(const Point<dim> &unit_point) const;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &value;
        for (double &density : densities)
          archive &density;
      }
    };

    Gap
    of_cell(const typename Triangulation<dim>::cell_iterator &cell) const;

    std::map<CellId, Gap> known;
  };
} // namespace ElastoPlastic

#endif
