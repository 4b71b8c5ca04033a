// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef multigrid_level_matching_h
#define multigrid_level_matching_h

#include <deal.II/base/partitioner.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>

#include <memory>

namespace ElastoPlastic
{
  using namespace dealii;



  /// The locally owned cells of a distributed mesh, numbered from zero in the
  /// order of the mesh, for data of cells: deal.II's partition of the active
  /// cells.
  template <int dim>
  class OwnedCells
  {
  public:
    /// The numbering is that of @p mesh as it is now.
    explicit OwnedCells(const Triangulation<dim> &mesh)
      : partition(dynamic_cast<const parallel::TriangulationBase<dim> &>(mesh)
                    .global_active_cell_index_partitioner()
                    .lock())
    {}

    unsigned int
    size() const
    {
      return partition->locally_owned_size();
    }

    /// The number of a locally owned cell.
    template <typename CellAccessor>
    unsigned int
    number(const CellAccessor &cell) const
    {
      return partition->global_to_local(cell.global_active_cell_index());
    }

    /// The same cells in a numbering of all cells of all ranks: rank by rank.
    const IndexSet &
    global_indices() const
    {
      return partition->locally_owned_range();
    }

  private:
    std::shared_ptr<const Utilities::MPI::Partitioner> partition;
  };



  /// What the owners of a coarse cell's children need to know about it. Each
  /// unknown is a combination of unconstrained ones.
  struct CoarseCell
  {
    using Combination = std::vector<std::pair<types::global_dof_index, double>>;

    CellId::binary_type      id;
    types::global_cell_index index;
    std::vector<Combination> unknowns;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &id &index &unknowns;
    }
  };



  /// Which unknowns and cells of two adjacent levels belong together, for the
  /// part of the fine level that this rank owns, in global numbers of the
  /// coarse one. The meshes may be partitioned in different ways: the owner of
  /// a coarse cell asks p4est who owns the fine cells in it, and tells them.
  template <int dim>
  class LevelMatching
  {
  public:
    using Constraints = AffineConstraints<double>;
    using Mesh        = parallel::distributed::Triangulation<dim>;

    LevelMatching(const DoFHandler<dim> &fine,
                  const Constraints     &fine_constraints,
                  const DoFHandler<dim> &coarse,
                  const Constraints     &coarse_constraints);

    /// The interpolation matrix: row k belongs to the local index rows[k] of
    /// the fine level and has the entries from row_starts[k] to row_starts[k +
    /// 1]. Constrained fine unknowns have no row.
    std::vector<unsigned int>                              rows;
    std::vector<unsigned int>                              row_starts = {0};
    std::vector<std::pair<types::global_dof_index, float>> entries;

    /// For each of the fine OwnedCells the coarse cell it is in, and its share
    /// of that.
    std::vector<std::pair<types::global_cell_index, float>> parents;

  private:
    using FineCell = typename DoFHandler<dim>::cell_iterator;

    CoarseCell
    describe(const typename DoFHandler<dim>::active_cell_iterator &cell) const;

    /// Finds the locally owned fine cells in @p coarse_cell.
    void
    match(const CoarseCell &coarse_cell);

    void
    match(const FineCell           &fine_cell,
          const CoarseCell         &coarse_cell,
          const FullMatrix<double> &interpolation,
          const float               share);

    const DoFHandler<dim> &fine;
    const Constraints     &fine_constraints;
    const DoFHandler<dim> &coarse;
    const Constraints     &coarse_constraints;

    const types::global_dof_index        first_dof;
    const OwnedCells<dim>                fine_cells;
    const OwnedCells<dim>                coarse_cells;
    std::vector<bool>                    has_row;
    FullMatrix<double>                   same_cell;
    std::vector<FullMatrix<double>>      from_parent;
    std::vector<types::global_dof_index> dofs;
  };
} // namespace ElastoPlastic

#endif
