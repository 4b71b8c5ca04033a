// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef multigrid_level_hierarchy_h
#define multigrid_level_hierarchy_h

#include <deal.II/base/mg_level_object.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/multigrid/mg_base.h>

#include <memory>
#include <vector>

#include "loads/supports.h"
#include "mechanics/solid_operator.h"
#include "multigrid/level_operator.h"
#include "multigrid/two_level_transfer.h"
#include "solver/tangent_preconditioner.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// @p mesh (the last one) and the meshes it has been refined from: level by
  /// level without the finest cells, wherever they are. The first one is the
  /// finest of those that have at most @p n_coarse_cells cells, or the one that
  /// p4est starts from. Each has its own partition, with the same number of
  /// cells for all ranks. @p mesh must outlive the others.
  ///
  /// This is deal.II's
  /// MGTransferGlobalCoarseningTools::create_geometric_coarsening_sequence(),
  /// but it coarsens in p4est, where it costs next to nothing, instead of
  /// copying the mesh itself first, which takes longer than solving.
  template <int dim>
  std::vector<std::shared_ptr<const Triangulation<dim>>>
  mesh_sequence(const parallel::distributed::Triangulation<dim> &mesh,
                const unsigned int n_coarse_cells);



  /// The transfer between all levels as Multigrid and PreconditionMG want to
  /// see it. It leaves held unknowns at zero, but what they do on slopes goes
  /// into the fields that are transferred.
  template <int dim>
  class LevelTransfer : public MGTransferBase<LevelVector>
  {
  public:
    using Operators = MGLevelObject<std::unique_ptr<LevelOperator<dim>>>;
    using Transfers = MGLevelObject<std::unique_ptr<TwoLevelTransfer<dim>>>;

    /// @p transfers, each with the level below it (none on level 0), and
    /// @p operators must
    /// outlive this object.
    LevelTransfer(const Transfers &transfers, const Operators &operators)
      : transfers(transfers)
      , operators(operators)
    {}


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

    /// Starts a cycle with @p source on the finest level, zero elsewhere.
    void
    copy_to_mg(const DoFHandler<dim>      &dof_handler,
               MGLevelObject<LevelVector> &levels,
               const VectorType           &source) const;

    void
    copy_from_mg(const DoFHandler<dim>            &dof_handler,
                 VectorType                       &result,
                 const MGLevelObject<LevelVector> &levels) const;

  private:
    const Transfers &transfers;
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
    LevelHierarchy(const LoadedBody<dim>           &body,
                   const DoFHandler<dim>           &dof_handler,
                   const AffineConstraints<double> &constraints,
                   const unsigned int               n_coarse_cells);

    /// Hands the stored tangent of @p solid and the @p held unknowns to all
    /// levels. A node of a coarse level is held as the node of the finest level
    /// at the same place is.
    void
    update(const SolidOperator<dim> &solid, const HeldUnknowns &held);

    unsigned int
    max_level() const
    {
      return levels.size() - 1;
    }

    const typename LevelTransfer<dim>::Operators &
    operators() const
    {
      return level_operators;
    }

    const LevelTransfer<dim> &
    transfer() const
    {
      return level_transfer;
    }

    /// Of level 0.
    const DoFHandler<dim> &
    coarse_dof_handler() const
    {
      return *levels[0].dof_handler;
    }

    const AffineConstraints<double> &
    coarse_constraints() const
    {
      return *levels[0].constraints;
    }

    const HeldUnknowns &
    held_on_coarsest() const
    {
      return held_on_coarsest_level;
    }

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
    add_level(const std::shared_ptr<const Triangulation<dim>> &mesh);

    void
    update_tangents(const SolidOperator<dim> &solid);

    const LoadedBody<dim> &body;
    std::vector<Level>     levels;

    typename LevelTransfer<dim>::Operators level_operators;
    typename LevelTransfer<dim>::Transfers two_level_transfers;
    const LevelTransfer<dim>               level_transfer;

    HeldUnknowns held_on_coarsest_level;
  };
} // namespace ElastoPlastic

#endif
