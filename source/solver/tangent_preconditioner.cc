// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/dofs/dof_tools.h>

#include <functional>

#include "base/compatibility.h"
#include "base/ghost_values.h"
#include "solver/tangent_preconditioner.h"

namespace ElastoPlastic
{
  template <int dim>
  void
  TangentMatrix<dim>::reinit(const DoFHandler<dim>           &new_dof_handler,
                             const AffineConstraints<double> &new_constraints)
  {
    dof_handler   = &new_dof_handler;
    constraints   = &new_constraints;
    relevant_dofs = DoFTools::extract_locally_relevant_dofs(*dof_handler);
    partners.clear();
    set_up_pattern();
  }



  template <int dim>
  void
  TangentMatrix<dim>::set_up_pattern()
  {
    IndexSet writable_rows = relevant_dofs;
    for (const auto &[dof, others] : partners)
      if (relevant_dofs.is_element(dof))
        writable_rows.add_indices(others.begin(), others.end());
    SystemPattern pattern = make_pattern(dof_handler->locally_owned_dofs(),
                                         writable_rows,
                                         communicator_of(*dof_handler));
    DoFTools::make_sparsity_pattern(*dof_handler, pattern, *constraints, false);
    if (!partners.empty())
      add_to_pattern_of_moves(pattern);
    pattern.compress();
    system_matrix.reinit(pattern);
    ++pattern_count;
  }



  template <int dim>
  void
  TangentMatrix<dim>::add_to_pattern_of_moves(SystemPattern &pattern) const
  {
    std::vector<types::global_dof_index> of_cell(
      dof_handler->get_fe().n_dofs_per_cell());
    for (const auto &cell : dof_handler->active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(of_cell);
          std::set<types::global_dof_index> all, moving;
          for (const auto dof : of_cell)
            if (const auto *masters = constraints->get_constraint_entries(dof))
              for (const auto &master : *masters)
                all.insert(master.first);
            else
              all.insert(dof);
          for (const auto dof : all)
            if (const auto found = partners.find(dof); found != partners.end())
              moving.insert(found->second.begin(), found->second.end());
          if (moving.empty())
            continue;
          all.insert(moving.begin(), moving.end());
          const std::vector<types::global_dof_index> columns(all.begin(),
                                                             all.end());
          for (const auto row : columns)
            pattern.add_entries(row, columns.begin(), columns.end(), true);
        }
  }



  // As -w_b = u_b + sum_c t_bc (-w_c) (doc/theory, "The edge of the
  // contact"), the outermost ones first. These have no row: the recursion ends.
  template <int dim>
  typename TangentMatrix<dim>::Moves
  TangentMatrix<dim>::moves_of(const SharedForces &shared) const
  {
    Moves moves;
    if (!shared.rows)
      return moves;
    VectorType layout(dof_handler->locally_owned_dofs(),
                      communicator_of(*dof_handler));
    Moves      rows;
    for (const auto &of_rank : Utilities::MPI::all_gather(
           communicator_of(*dof_handler),
           shared.rows->global_entries(*layout.get_partitioner())))
      for (const auto &[row, column, value] : of_rank)
        rows[row][column] = value;

    const std::function<const Combination &(types::global_dof_index)> find =
      [&](const types::global_dof_index unknown) -> const Combination & {
      const auto [move, is_new] = moves.try_emplace(unknown);
      if (const auto row = rows.find(unknown); is_new && row != rows.end())
        for (const auto &[entering, share] : row->second)
          {
            move->second[entering] += share;
            for (const auto &[outer, value] : find(entering))
              move->second[outer] += share * value;
          }
      return move->second;
    };
    for (const auto &row : rows)
      find(row.first);
    return moves;
  }



  template <int dim>
  void
  TangentMatrix<dim>::make_room_for(const Moves &moves)
  {
    bool is_new = false;
    for (const auto &[unknown, combination] : moves)
      for (const auto &entry : combination)
        is_new |= partners[unknown].insert(entry.first).second;
    if (is_new)
      set_up_pattern();
  }



  // A spring acts on -w_b.
  template <int dim>
  void
  TangentMatrix<dim>::add_springs(const HeldUnknowns &held, const Moves &moves)
  {
    if (held.springs.size() == 0)
      return;
    for (const types::global_dof_index dof : dof_handler->locally_owned_dofs())
      if (const double stiffness = held.springs(dof);
          stiffness != 0. && held.constrained(dof) == 0.)
        {
          Combination opening;
          if (const auto found = moves.find(dof); found != moves.end())
            opening = found->second;
          opening[dof] = 1.;
          for (const auto &[row, at_row] : opening)
            for (const auto &[column, at_column] : opening)
              system_matrix.add(row, column, stiffness * at_row * at_column);
        }
    system_matrix.compress(VectorOperation::add);
  }



  template <int dim>
  AffineConstraints<double>
  TangentMatrix<dim>::with_held(const HeldUnknowns &held,
                                const Moves        &moves) const
  {
    const VectorType constrained = ghosted_copy(held.constrained, *dof_handler);
    const bool       is_sloped   = held.slopes.size() > 0;
    const VectorType slopes =
      is_sloped ? ghosted_copy(held.slopes, *dof_handler) : VectorType();

    auto all_constraints = empty_constraints(*dof_handler);
    all_constraints.merge(*constraints);
    for (const types::global_dof_index dof : relevant_dofs)
      if (constrained(dof) != 0.)
        {
          all_constraints.add_line(dof);
          if (is_sloped)
            for_each_slope<dim>(
              dof,
              [&](const auto other) { return slopes(other); },
              [&](const auto other, const double slope) {
                if (constrained(other) == 0.)
                  all_constraints.add_entry(dof, other, slope);
              });
        }
    for (const auto &[unknown, combination] : moves)
      if (relevant_dofs.is_element(unknown) && constrained(unknown) != 0.)
        for (const auto &[entering, value] : combination)
          all_constraints.add_entry(unknown, entering, -value);
    all_constraints.close();
    return all_constraints;
  }



  template class TangentMatrix<2>;
  template class TangentMatrix<3>;
} // namespace ElastoPlastic
