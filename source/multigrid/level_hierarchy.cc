// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include "multigrid/level_hierarchy.h"
#include "multigrid/level_matching.h"

namespace ElastoPlastic
{
  template <int dim>
  void
  LevelTransfer<dim>::prolongate(const unsigned int to_level,
                                 LevelVector       &fine,
                                 const LevelVector &coarse) const
  {
    fine = 0.f;
    prolongate_and_add(to_level, fine, coarse);
  }



  template <int dim>
  void
  LevelTransfer<dim>::prolongate_and_add(const unsigned int to_level,
                                         LevelVector       &fine,
                                         const LevelVector &coarse) const
  {
    const LevelOperator<dim> &coarse_operator = *operators[to_level - 1];
    if (coarse_operator.has_slopes())
      {
        LevelVector expanded = coarse;
        coarse_operator.expand(expanded);
        transfers[to_level]->prolongate_and_add(fine, expanded);
      }
    else
      transfers[to_level]->prolongate_and_add(fine, coarse);
    operators[to_level]->zero_constrained(fine);
  }



  template <int dim>
  void
  LevelTransfer<dim>::restrict_and_add(const unsigned int from_level,
                                       LevelVector       &coarse,
                                       const LevelVector &fine) const
  {
    transfers[from_level]->restrict_and_add(coarse, fine);
    operators[from_level - 1]->contract(coarse);
    operators[from_level - 1]->zero_constrained(coarse);
  }



  template <int dim>
  void
  LevelTransfer<dim>::copy_to_mg(const DoFHandler<dim> &,
                                 MGLevelObject<LevelVector> &levels,
                                 const VectorType           &source) const
  {
    for (unsigned int level = 0; level <= levels.max_level(); ++level)
      operators[level]->initialize_vector(levels[level]);
    levels[levels.max_level()].copy_locally_owned_data_from(source);
  }



  template <int dim>
  void
  LevelTransfer<dim>::copy_from_mg(
    const DoFHandler<dim> &,
    VectorType                       &result,
    const MGLevelObject<LevelVector> &levels) const
  {
    result.copy_locally_owned_data_from(levels[levels.max_level()]);
  }



  template <int dim>
  LevelHierarchy<dim>::LevelHierarchy(
    const LoadedBody<dim>           &body,
    const DoFHandler<dim>           &dof_handler,
    const AffineConstraints<double> &constraints,
    const unsigned int               n_coarse_cells)
    : body(body)
    , level_transfer(two_level_transfers, level_operators)
  {
    const unsigned int degree = dof_handler.get_fe().degree;
    const auto         meshes = mesh_sequence(
      dynamic_cast<const parallel::distributed::Triangulation<dim> &>(
        dof_handler.get_triangulation()),
      n_coarse_cells);
    for (const auto &mesh : meshes)
      if (mesh != meshes.back() || degree > 1)
        add_level(mesh);
    levels.push_back({meshes.back(), {}, {}, &dof_handler, &constraints});

    // (The finest operator first: to set it up takes most of the memory.)
    level_operators.resize(0, max_level());
    for (unsigned int l = max_level() + 1; l-- > 0;)
      {
        const Level       &level        = levels[l];
        const unsigned int level_degree = level.dof_handler->get_fe().degree;
        // Quadratic elements do not lock, so the linear ones that correct them
        // must not either.
        level_operators[l] = std::make_unique<LevelOperator<dim>>(
          level_degree < degree ?
            body.strain_model.with_treatment(VolumetricTreatment::b_bar) :
            body.strain_model,
          *level.dof_handler,
          *level.constraints);
      }
    two_level_transfers.resize(0, max_level()); // none on level 0
    for (unsigned int l = 1; l <= max_level(); ++l)
      two_level_transfers[l] =
        std::make_unique<TwoLevelTransfer<dim>>(*levels[l].dof_handler,
                                                *levels[l].constraints,
                                                *levels[l - 1].dof_handler,
                                                *levels[l - 1].constraints);
  }



  template <int dim>
  void
  LevelHierarchy<dim>::add_level(
    const std::shared_ptr<const Triangulation<dim>> &mesh)
  {
    Level level = {mesh,
                   std::make_unique<DoFHandler<dim>>(*mesh),
                   std::make_unique<Supports<dim>>(body),
                   nullptr,
                   nullptr};
    level.own_dof_handler->distribute_dofs(FESystem<dim>(FE_Q<dim>(1), dim));
    level.own_supports->reinit(*level.own_dof_handler);
    level.dof_handler = level.own_dof_handler.get();
    level.constraints = &level.own_supports->constraints();
    levels.push_back(std::move(level));
  }



  template <int dim>
  void
  LevelHierarchy<dim>::update(const SolidOperator<dim> &solid,
                              const HeldUnknowns       &held)
  {
    update_tangents(solid);

    LevelVector constrained, slopes, springs, coarse;
    level_operators[max_level()]->initialize_vector(constrained);
    slopes.reinit(constrained);
    springs.reinit(constrained);
    constrained.copy_locally_owned_data_from(held.constrained);
    if (held.slopes.size() > 0)
      slopes.copy_locally_owned_data_from(held.slopes);
    if (held.springs.size() > 0)
      springs.copy_locally_owned_data_from(held.springs);
    for (unsigned int l = max_level();; --l)
      {
        level_operators[l]->set_held(constrained, slopes);
        level_operators[l]->set_springs(springs);
        if (l == max_level())
          level_operators[l]->set_shared(held.shared);
        if (l == 0)
          break;
        level_operators[l - 1]->initialize_vector(coarse);
        for (LevelVector *field : {&constrained, &slopes})
          {
            two_level_transfers[l]->inject(coarse, *field);
            *field = coarse;
          }
        coarse = 0.f;
        two_level_transfers[l]->restrict_and_add(coarse, springs);
        springs = coarse;
      }
    for (const auto &[copy, field] :
         {std::pair{&held_on_coarsest_level.constrained, &constrained},
          std::pair{&held_on_coarsest_level.slopes, &slopes},
          std::pair{&held_on_coarsest_level.springs, &springs}})
      {
        copy->reinit(field->get_partitioner());
        copy->copy_locally_owned_data_from(*field);
      }
  }



  // One number of the tangent after the other: this needs less memory than all
  // at once.
  template <int dim>
  void
  LevelHierarchy<dim>::update_tangents(const SolidOperator<dim> &solid)
  {
    const OwnedCells<dim>    cells(*levels.back().mesh);
    std::vector<LevelVector> values(
      CellTangents<dim>::n_values(body.strain_model.has_nominal_tangents()));
    for (LevelVector &value : values)
      value.reinit(cells.size());
    solid.for_each_cell_tangent(
      [&](const auto &cell, const std::vector<double> &of_cell) {
        for (unsigned int i = 0; i < values.size(); ++i)
          values[i].local_element(cells.number(*cell)) = of_cell[i];
      });

    for (unsigned int i = 0; i < values.size(); ++i)
      for (unsigned int l = max_level();; --l)
        {
          level_operators[l]->set_tangent_value(i, values[i]);
          if (l == 0)
            break;
          LevelVector coarse_value;
          two_level_transfers[l]->average_cells(coarse_value, values[i]);
          values[i].swap(coarse_value);
        }
    for (unsigned int l = 0; l <= max_level(); ++l)
      level_operators[l]->finish_tangents();
  }



  template class LevelTransfer<2>;
  template class LevelTransfer<3>;
  template class LevelHierarchy<2>;
  template class LevelHierarchy<3>;
} // namespace ElastoPlastic
