// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef multigrid_level_hierarchy_h
#define multigrid_level_hierarchy_h

#include <deal.II/base/mg_level_object.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

#include <memory>
#include <vector>

#include "mechanics/supports.h"
#include "multigrid/level_operator.h"

namespace ElastoPlastic
{
  /// Multigrid's transfer between levels, which leaves held unknowns at zero.
  template <int dim>
  class LevelTransfer : public MGTransferGlobalCoarsening<dim, LevelVector>
  {
  public:
    using Base      = MGTransferGlobalCoarsening<dim, LevelVector>;
    using Operators = MGLevelObject<std::unique_ptr<LevelOperator<dim>>>;

    /// @p operators must outlive this object.
    LevelTransfer(
      const MGLevelObject<MGTwoLevelTransfer<dim, LevelVector>> &transfers,
      const Operators                                           &operators);

    void
    prolongate(const unsigned int to_level,
               LevelVector       &fine,
               const LevelVector &coarse) const override;

    void
    prolongate_and_add(const unsigned int to_level,
                       LevelVector       &fine,
                       const LevelVector &coarse) const override;

    void
    restrict_and_add(const unsigned int from_level,
                     LevelVector       &coarse,
                     const LevelVector &fine) const override;

  private:
    const Operators &operators;
  };



  /// The levels of geometric multigrid by global coarsening
  /// @cite munch_heister_2022: a sequence of meshes in which every cell that
  /// can be coarsened is coarsened at once, so that each level covers the whole
  /// body and has its hanging nodes constrained like the finest mesh. Linear
  /// elements on all of them; quadratic elements make one more level on the
  /// finest mesh. Level 0 is the coarsest.
  template <int dim>
  class LevelHierarchy
  {
  public:
    /// The coarsest mesh is the finest one of those that have at most
    /// @p n_coarse_cells cells, or the mesh that all others come from. All
    /// arguments must outlive this object.
    LevelHierarchy(const DoFHandler<dim>           &dof_handler,
                   const AffineConstraints<double> &constraints,
                   const BoundaryConditions<dim>   &boundary_conditions,
                   const VolumetricTreatment        treatment,
                   const unsigned int               n_coarse_cells);

    /// Hands the stored tangent of @p solid and the held unknowns (ones there,
    /// zeros elsewhere) to all levels. A node of a coarse level is held if the
    /// node of the finest level at the same place is.
    void
    update(const SolidOperator<dim> &solid, const VectorType &held);

    unsigned int
    max_level() const;

    const typename LevelTransfer<dim>::Operators &
    operators() const;

    const LevelTransfer<dim> &
    transfer() const;

    /// Of level 0.
    const DoFHandler<dim> &
    coarse_dof_handler() const;

    const AffineConstraints<double> &
    coarse_constraints() const;

    const LevelVector &
    coarse_held() const;

  private:
    /// A level's unknowns. The finest level uses those of the problem.
    struct Level
    {
      std::shared_ptr<const Triangulation<dim>> mesh;
      std::unique_ptr<DoFHandler<dim>>          own_dof_handler;
      std::unique_ptr<Supports<dim>>            own_supports;

      const DoFHandler<dim>           *dof_handler;
      const AffineConstraints<double> *constraints;
    };

    void
    add_level(const std::shared_ptr<const Triangulation<dim>> &mesh,
              const BoundaryConditions<dim> &boundary_conditions);

    void
    set_up_operators(const VolumetricTreatment treatment);

    void
    set_up_transfers();

    void
    update_tangents(const SolidOperator<dim> &solid);

    std::vector<Level> levels;

    /// For each mesh, not for each level, a numbering of the cells.
    std::vector<std::unique_ptr<DoFHandler<dim>>> cell_dof_handlers;
    const FE_DGQ<dim>                             cell_fe;

    typename LevelTransfer<dim>::Operators level_operators;
    std::unique_ptr<LevelTransfer<dim>>    level_transfer;
    std::unique_ptr<MGTransferGlobalCoarsening<dim, LevelVector>> cell_transfer;

    LevelVector held_on_coarsest_level;
  };
} // namespace ElastoPlastic

#endif
