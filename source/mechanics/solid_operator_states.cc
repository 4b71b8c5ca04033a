// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What the points remember, from one step to the next, for other meshes and for
// checkpoints.

#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  template <int dim>
  void
  SolidOperator<dim>::keep_increments()
  {
    history.keep_increments();
  }



  template <int dim>
  bool
  SolidOperator<dim>::keeps_increments() const
  {
    return history.keeps_increments();
  }



  template <int dim>
  void
  SolidOperator<dim>::begin_step(const double duration)
  {
    history.extrapolate(0.);
    materials.set_step_duration(duration);
  }



  template <int dim>
  void
  SolidOperator<dim>::go_on(const double duration, const double last)
  {
    const double ratio = duration / last;
    history.extrapolate(ratio * ratio / (1. + 2. * ratio));
    materials.set_step_duration(duration * (1. + ratio) / (1. + 2. * ratio));
  }



  template <int dim>
  double
  SolidOperator<dim>::extrapolation_weight() const
  {
    return history.extrapolation_weight();
  }



  template <int dim>
  void
  SolidOperator<dim>::commit(const VectorType &u)
  {
    const bool time_has_passed = step_duration() > 0.;
    kernel->for_each_batch({&u}, [&](const std::vector<Strains> &strains) {
      const unsigned int batch = strains[0].batch;
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const auto state = response(strains[0], q).plasticity().state();
          if (time_has_passed)
            history.end_step(batch, q, state);
          else
            history.set_state(batch, q, state);
        }
    });
    begin_step(0.);
  }



  template <int dim>
  void
  SolidOperator<dim>::for_each_state(
    const std::function<void(const CellIterator &, std::vector<double> &&)>
      &visit) const
  {
    for (unsigned int batch = 0; batch < kernel->n_batches(); ++batch)
      for (unsigned int lane = 0; lane < kernel->n_cells(batch); ++lane)
        visit(kernel->cell(batch, lane), history.cell_values(batch, lane));
  }



  template <int dim>
  CellStates
  SolidOperator<dim>::states() const
  {
    CellStates result(kernel->n_active_cells());
    for_each_state([&](const CellIterator &cell, std::vector<double> &&state) {
      result[cell->active_cell_index()] = std::move(state);
    });
    return result;
  }



  template <int dim>
  void
  SolidOperator<dim>::set_states(
    const std::function<std::vector<double>(const CellIterator &)> &state_of)
  {
    Assert(extrapolation_weight() == 0., ExcInternalError());
    for (unsigned int batch = 0; batch < kernel->n_batches(); ++batch)
      {
        for (unsigned int lane = 0; lane < kernel->n_cells(batch); ++lane)
          history.set_cell_values(batch,
                                  lane,
                                  state_of(kernel->cell(batch, lane)));
        for (unsigned int q = 0; q < n_points; ++q)
          {
            MaterialState<Number> state = history.state(batch, q);
            make_admissible(state, materials[batch]);
            history.set_state(batch, q, state);
          }
      }
  }



  template <int dim>
  void
  SolidOperator<dim>::set_states(const CellStates &states)
  {
    set_states([&](const CellIterator &cell) {
      return states[cell->active_cell_index()];
    });
  }
} // namespace ElastoPlastic
