// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_q.h>

#include "multigrid/level_hierarchy.h"
#include "multigrid/mesh_sequence.h"

namespace ElastoPlastic
{
  namespace
  {
    AffineConstraints<float>
    in_single_precision(const AffineConstraints<double> &constraints)
    {
      AffineConstraints<float> result;
      result.copy_from(constraints);
      return result;
    }
  } // namespace



  template <int dim>
  LevelTransfer<dim>::LevelTransfer(
    const MGLevelObject<MGTwoLevelTransfer<dim, LevelVector>> &transfers,
    const Operators                                           &operators)
    : Base(transfers,
           [&operators](const unsigned int level, LevelVector &vector) {
             operators[level]->initialize_vector(vector);
           })
    , operators(operators)
  {
    std::vector<std::shared_ptr<const Utilities::MPI::Partitioner>>
      partitioners;
    for (unsigned int level = 0; level <= operators.max_level(); ++level)
      {
        LevelVector vector;
        operators[level]->initialize_vector(vector);
        partitioners.push_back(vector.get_partitioner());
      }
    this->build(partitioners);
  }



  template <int dim>
  void
  LevelTransfer<dim>::prolongate(const unsigned int to_level,
                                 LevelVector       &fine,
                                 const LevelVector &coarse) const
  {
    Base::prolongate(to_level, fine, coarse);
    operators[to_level]->zero_held(fine);
  }



  template <int dim>
  void
  LevelTransfer<dim>::prolongate_and_add(const unsigned int to_level,
                                         LevelVector       &fine,
                                         const LevelVector &coarse) const
  {
    Base::prolongate_and_add(to_level, fine, coarse);
    operators[to_level]->zero_held(fine);
  }



  template <int dim>
  void
  LevelTransfer<dim>::restrict_and_add(const unsigned int from_level,
                                       LevelVector       &coarse,
                                       const LevelVector &fine) const
  {
    Base::restrict_and_add(from_level, coarse, fine);
    operators[from_level - 1]->zero_held(coarse);
  }



  template <int dim>
  LevelHierarchy<dim>::LevelHierarchy(
    const DoFHandler<dim>           &dof_handler,
    const AffineConstraints<double> &constraints,
    const BoundaryConditions<dim>   &boundary_conditions,
    const VolumetricTreatment        treatment,
    const unsigned int               n_coarse_cells)
    : cell_fe(0)
  {
    const unsigned int degree = dof_handler.get_fe().degree;
    const auto         meshes = mesh_sequence(
      dynamic_cast<const parallel::distributed::Triangulation<dim> &>(
        dof_handler.get_triangulation()),
      n_coarse_cells);

    for (const auto &mesh : meshes)
      {
        if (mesh != meshes.back() || degree > 1)
          add_level(mesh, boundary_conditions);
        cell_dof_handlers.push_back(std::make_unique<DoFHandler<dim>>(*mesh));
        cell_dof_handlers.back()->distribute_dofs(cell_fe);
      }
    levels.push_back({meshes.back(), {}, {}, &dof_handler, &constraints});

    set_up_operators(treatment);
    set_up_transfers();
  }



  template <int dim>
  void
  LevelHierarchy<dim>::add_level(
    const std::shared_ptr<const Triangulation<dim>> &mesh,
    const BoundaryConditions<dim>                   &boundary_conditions)
  {
    Level level = {mesh,
                   std::make_unique<DoFHandler<dim>>(*mesh),
                   std::make_unique<Supports<dim>>(),
                   nullptr,
                   nullptr};
    level.own_dof_handler->distribute_dofs(FESystem<dim>(FE_Q<dim>(1), dim));
    level.own_supports->reinit(*level.own_dof_handler,
                               boundary_conditions,
                               /* time = */ 0.);
    level.dof_handler = level.own_dof_handler.get();
    level.constraints = &level.own_supports->constraints();
    levels.push_back(std::move(level));
  }



  template <int dim>
  void
  LevelHierarchy<dim>::set_up_operators(const VolumetricTreatment treatment)
  {
    level_operators.resize(0, max_level());
    for (unsigned int l = 0; l <= max_level(); ++l)
      {
        const auto &[mesh, own_dofs, own_supports, dof_handler, constraints] =
          levels[l];
        level_operators[l] =
          make_level_operator<dim>(dof_handler->get_fe().degree, treatment);
        level_operators[l]->reinit(*dof_handler,
                                   *constraints,
                                   *cell_dof_handlers[std::min<std::size_t>(
                                     l, cell_dof_handlers.size() - 1)]);
      }
  }



  template <int dim>
  void
  LevelHierarchy<dim>::set_up_transfers()
  {
    MGLevelObject<MGTwoLevelTransfer<dim, LevelVector>> transfers(0,
                                                                  max_level());
    for (unsigned int l = 1; l <= max_level(); ++l)
      transfers[l].reinit(*levels[l].dof_handler,
                          *levels[l - 1].dof_handler,
                          in_single_precision(*levels[l].constraints),
                          in_single_precision(*levels[l - 1].constraints));
    level_transfer =
      std::make_unique<LevelTransfer<dim>>(transfers, level_operators);

    MGLevelObject<MGTwoLevelTransfer<dim, LevelVector>> cell_transfers(
      0, cell_dof_handlers.size() - 1);
    for (unsigned int m = 1; m < cell_dof_handlers.size(); ++m)
      cell_transfers[m].reinit(*cell_dof_handlers[m],
                               *cell_dof_handlers[m - 1]);
    cell_transfer =
      std::make_unique<MGTransferGlobalCoarsening<dim, LevelVector>>(
        cell_transfers, [this](const unsigned int mesh, LevelVector &vector) {
          vector.reinit(cell_dof_handlers[mesh]->locally_owned_dofs(),
                        cell_dof_handlers[mesh]->get_communicator());
        });
  }



  template <int dim>
  void
  LevelHierarchy<dim>::update(const SolidOperator<dim> &solid,
                              const VectorType         &held)
  {
    update_tangents(solid);

    LevelVector fine_held;
    level_operators[max_level()]->initialize_vector(fine_held);
    fine_held.copy_locally_owned_data_from(held);
    MGLevelObject<LevelVector> level_held(0, max_level());
    level_transfer->interpolate_to_mg(level_held, fine_held);

    for (unsigned int l = 0; l <= max_level(); ++l)
      level_operators[l]->set_held(level_held[l]);
    held_on_coarsest_level = level_held[0];
  }



  // One number of the tangent after the other: this needs less memory than all
  // at once, and the transfer between the meshes is the same for all.
  template <int dim>
  void
  LevelHierarchy<dim>::update_tangents(const SolidOperator<dim> &solid)
  {
    const DoFHandler<dim> &cell_dof_handler = *cell_dof_handlers.back();
    std::array<LevelVector, CellTangent<dim>::n_values> values;
    for (LevelVector &value : values)
      value.reinit(cell_dof_handler.locally_owned_dofs(),
                   cell_dof_handler.get_communicator());
    std::vector<types::global_dof_index> index(1);
    solid.for_each_cell_tangent([&](const auto             &cell,
                                    const CellTangent<dim> &tangent) {
      typename DoFHandler<dim>::active_cell_iterator(&cell->get_triangulation(),
                                                     cell->level(),
                                                     cell->index(),
                                                     &cell_dof_handler)
        ->get_dof_indices(index);
      const auto numbers = tangent.values();
      for (unsigned int i = 0; i < values.size(); ++i)
        values[i](index[0]) = numbers[i];
    });

    for (unsigned int i = 0; i < values.size(); ++i)
      {
        MGLevelObject<LevelVector> level_values(0,
                                                cell_dof_handlers.size() - 1);
        cell_transfer->interpolate_to_mg(level_values, values[i]);
        for (unsigned int l = 0; l <= max_level(); ++l)
          level_operators[l]->set_tangent_value(
            i,
            level_values[std::min<unsigned int>(l, level_values.max_level())]);
      }
  }



  template <int dim>
  unsigned int
  LevelHierarchy<dim>::max_level() const
  {
    return levels.size() - 1;
  }



  template <int dim>
  const typename LevelTransfer<dim>::Operators &
  LevelHierarchy<dim>::operators() const
  {
    return level_operators;
  }



  template <int dim>
  const LevelTransfer<dim> &
  LevelHierarchy<dim>::transfer() const
  {
    return *level_transfer;
  }



  template <int dim>
  const DoFHandler<dim> &
  LevelHierarchy<dim>::coarse_dof_handler() const
  {
    return *levels[0].dof_handler;
  }



  template <int dim>
  const AffineConstraints<double> &
  LevelHierarchy<dim>::coarse_constraints() const
  {
    return *levels[0].constraints;
  }



  template <int dim>
  const LevelVector &
  LevelHierarchy<dim>::coarse_held() const
  {
    return held_on_coarsest_level;
  }



  template class LevelTransfer<2>;
  template class LevelTransfer<3>;
  template class LevelHierarchy<2>;
  template class LevelHierarchy<3>;
} // namespace ElastoPlastic
