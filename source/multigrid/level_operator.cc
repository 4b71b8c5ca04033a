// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "multigrid/level_matching.h"
#include "multigrid/level_operator.h"

namespace ElastoPlastic
{
  template <int dim>
  LevelOperator<dim>::LevelOperator(
    const StrainModel               &strain_model,
    const DoFHandler<dim>           &dof_handler,
    const AffineConstraints<double> &constraints)
    : kernel(make_level_kernel<dim>(dof_handler.get_fe().degree, strain_model))
    , tangents(strain_model.has_nominal_tangents())
  {
    kernel->reinit(dof_handler, constraints);
    cut_off_indices = kernel->eliminated_entries();

    tangents.reinit(kernel->n_batches());
    cells.resize(kernel->n_batches());
    const OwnedCells<dim> owned_cells(dof_handler.get_triangulation());
    for (unsigned int batch = 0; batch < cells.size(); ++batch)
      for (unsigned int lane = 0; lane < Number::size(); ++lane)
        cells[batch][lane] = owned_cells.number(
          *kernel->cell(batch, std::min(lane, kernel->n_cells(batch) - 1)));
  }



  template <int dim>
  void
  LevelOperator<dim>::set_tangent_value(const unsigned int index,
                                        const LevelVector &values)
  {
    for (unsigned int batch = 0; batch < cells.size(); ++batch)
      {
        Number &value = tangents.value(batch, index);
        for (unsigned int lane = 0; lane < Number::size(); ++lane)
          value[lane] = values.local_element(cells[batch][lane]);
      }
  }



  template <int dim>
  void
  LevelOperator<dim>::set_held(const LevelVector &constrained,
                               const LevelVector &slopes)
  {
    constrained_indices.clear();
    held_slopes = {};
    for (unsigned int i = 0; i < constrained.locally_owned_size(); ++i)
      if (constrained.local_element(i) > 0.5f)
        {
          constrained_indices.push_back(i);
          for_each_slope<dim>(
            i,
            [&](const unsigned int j) { return slopes.local_element(j); },
            [&](const unsigned int j, const float slope) {
              held_slopes.add(i, j, slope);
            });
        }
    cut_off_indices = kernel->eliminated_entries();
    cut_off_indices.insert(cut_off_indices.end(),
                           constrained_indices.begin(),
                           constrained_indices.end());
  }



  template <int dim>
  void
  LevelOperator<dim>::set_springs(const LevelVector &stiffnesses)
  {
    springs.clear();
    for (unsigned int i = 0; i < stiffnesses.locally_owned_size(); ++i)
      if (const float stiffness = stiffnesses.local_element(i); stiffness > 0.f)
        springs.push_back({i, stiffness});
  }



  template <int dim>
  void
  LevelOperator<dim>::set_shared(const SharedForces &shared_forces)
  {
    shared = shared_forces;
    entering_values.resize(shared.entering.size());
  }



  template <int dim>
  void
  LevelOperator<dim>::move_held(LevelVector &vector) const
  {
    if (!shared.rows)
      return;
    auto entering = shared.entering.begin();
    shared.rows->sums(vector, [&](const unsigned int i, const double sum) {
      while (entering != shared.entering.end() && entering->index < i)
        ++entering;
      if (entering == shared.entering.end() || entering->index != i)
        vector.local_element(i) -= sum;
    });
  }



  template <int dim>
  void
  LevelOperator<dim>::share_forces(LevelVector &forces) const
  {
    if (!shared.rows)
      return;
    for (unsigned int k = 0; k < shared.entering.size(); ++k)
      std::swap(entering_values[k] = 0.f,
                forces.local_element(shared.entering[k].index));
    unsigned int k = 0;
    shared.rows->shares(forces, [&](const unsigned int i, const double share) {
      if (k < shared.entering.size() && shared.entering[k].index == i)
        forces.local_element(i) = entering_values[k++] - share;
    });
  }



  // The entries of vector at the unknowns that are cut off are zero for the
  // time of the loop: the operator is symmetric.
  template <int dim>
  void
  LevelOperator<dim>::vmult(LevelVector       &result,
                            const LevelVector &vector) const
  {
    auto &source = const_cast<LevelVector &>(vector);
    cut_off_values.resize(cut_off_indices.size());
    for (unsigned int i = 0; i < cut_off_indices.size(); ++i)
      std::swap(cut_off_values[i] = 0.f,
                source.local_element(cut_off_indices[i]));

    move_held(source);
    expand(source);
    kernel->vmult(result, vector, tangents);
    contract(result);
    share_forces(result);
    for (const auto &[index, stiffness] : springs)
      result.local_element(index) += stiffness * vector.local_element(index);

    for (unsigned int i = 0; i < cut_off_indices.size(); ++i)
      {
        source.local_element(cut_off_indices[i]) = cut_off_values[i];
        result.local_element(cut_off_indices[i]) = cut_off_values[i];
      }
  }



  template <int dim>
  types::global_dof_index
  LevelOperator<dim>::m() const
  {
    LevelVector vector;
    initialize_vector(vector);
    return vector.size();
  }



  template <int dim>
  float
  LevelOperator<dim>::el(
    const types::global_dof_index                  row,
    [[maybe_unused]] const types::global_dof_index column) const
  {
    AssertDimension(row, column);
    LevelVector inverse;
    inverse_diagonal(inverse);
    return 1.f / inverse(row);
  }



  template <int dim>
  void
  LevelOperator<dim>::inverse_diagonal(LevelVector &values) const
  {
    kernel->diagonal(values, tangents);
    held_slopes.contract_diagonal(values);
    add_edge_to_diagonal(values);
    for (const unsigned int i : cut_off_indices)
      values.local_element(i) = 1.f;
    for (unsigned int i = 0; i < values.locally_owned_size(); ++i)
      values.local_element(i) = 1.f / values.local_element(i);
  }



  // As the shares t_jb of no j exceed 1 together, and (sum_b t_jb u_b)^2 <=
  // sum_b t_jb u_b^2 then, this is enough for that what is shared raises no
  // eigenvalue that counts for a smoother. Nor do springs.
  template <int dim>
  void
  LevelOperator<dim>::add_edge_to_diagonal(LevelVector &values) const
  {
    unsigned int k = 0;
    if (shared.rows)
      shared.rows->shares(values,
                          [&](const unsigned int i, const double share) {
                            if (k < shared.entering.size() &&
                                shared.entering[k].index == i)
                              {
                                values.local_element(i) += share;
                                ++k;
                              }
                          });
    for (const auto &[index, stiffness] : springs)
      values.local_element(index) += stiffness;
  }



  template <int dim>
  void
  LevelOperator<dim>::copy_at_springs(LevelVector       &to,
                                      const LevelVector &from) const
  {
    for (const Spring &spring : springs)
      to.local_element(spring.index) = from.local_element(spring.index);
  }



  template <int dim>
  void
  LevelOperator<dim>::zero_constrained(LevelVector &vector) const
  {
    for (const unsigned int i : constrained_indices)
      vector.local_element(i) = 0.f;
  }



  template class LevelOperator<2>;
  template class LevelOperator<3>;
} // namespace ElastoPlastic
