// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <utility>

#include "mechanics/eliminated_unknowns.h"

namespace ElastoPlastic
{
  namespace
  {
    bool
    is_local(const types::global_dof_index      dof,
             const Utilities::MPI::Partitioner &layout)
    {
      return layout.in_local_range(dof) || layout.is_ghost_entry(dof);
    }
  } // namespace



  template <int dim, typename Number>
  void
  EliminatedUnknowns<dim, Number>::reinit(
    const AffineConstraints<double>   &constraints,
    const Utilities::MPI::Partitioner &layout)
  {
    using Entry   = typename NodalInterpolation<dim, Number>::Entry;
    interpolation = {};
    std::vector<Entry> entries;
    for (const auto &line : constraints.get_lines())
      if (is_local(line.index, layout))
        {
          entries.clear();
          for (const auto &[master, weight] : line.entries)
            {
              AssertThrow(is_local(master, layout), ExcInternalError());
              entries.push_back(
                {layout.global_to_local(master), static_cast<Number>(weight)});
            }
          interpolation.add(layout.global_to_local(line.index), entries);
        }
    interpolation.finish();
    remembered.resize(interpolation.n_unknowns());
  }



  template <int dim, typename Number>
  void
  EliminatedUnknowns<dim, Number>::expand(Vector &vector) const
  {
    Number *const values = vector.begin();
    auto          kept   = remembered.begin();
    interpolation.interpolate(values,
                              [&](const unsigned int i, const Number value) {
                                *kept++ = std::exchange(values[i], value);
                              });
  }



  template <int dim, typename Number>
  void
  EliminatedUnknowns<dim, Number>::restore(Vector &vector) const
  {
    Number *const values = vector.begin();
    auto          kept   = remembered.begin();
    interpolation.for_each_unknown(
      [&](const unsigned int i) { values[i] = *kept++; });
  }



  template <int dim, typename Number>
  void
  EliminatedUnknowns<dim, Number>::condense(Vector &forces) const
  {
    Number *const values = forces.begin();
    interpolation.add_transpose(values, [&](const unsigned int i) {
      return std::exchange(values[i], Number(0.));
    });
  }



  template class EliminatedUnknowns<2, float>;
  template class EliminatedUnknowns<3, float>;
  template class EliminatedUnknowns<2, double>;
  template class EliminatedUnknowns<3, double>;
} // namespace ElastoPlastic
