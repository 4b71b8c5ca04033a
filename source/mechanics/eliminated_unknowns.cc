// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "mechanics/eliminated_unknowns.h"

namespace ElastoPlastic
{
  template <typename Number>
  void
  EliminatedUnknowns<Number>::reinit(
    const AffineConstraints<double>   &constraints,
    const Utilities::MPI::Partitioner &layout)
  {
    unknowns.clear();
    row_starts = {0};
    entries.clear();
    const auto is_local = [&](const types::global_dof_index dof) {
      return layout.in_local_range(dof) || layout.is_ghost_entry(dof);
    };
    for (const auto &line : constraints.get_lines())
      if (is_local(line.index))
        {
          unknowns.push_back(layout.global_to_local(line.index));
          for (const auto &[master, weight] : line.entries)
            {
              Assert(is_local(master), ExcInternalError());
              entries.push_back(
                {layout.global_to_local(master), static_cast<Number>(weight)});
            }
          row_starts.push_back(entries.size());
        }
    remembered.resize(unknowns.size());
  }



  template <typename Number>
  void
  EliminatedUnknowns<Number>::expand(Vector &vector) const
  {
    for (unsigned int k = 0; k < unknowns.size(); ++k)
      {
        Number sum = 0.;
        for (unsigned int j = row_starts[k]; j < row_starts[k + 1]; ++j)
          sum += entries[j].weight * vector.local_element(entries[j].master);
        Number &value = vector.local_element(unknowns[k]);
        remembered[k] = value;
        value         = sum;
      }
  }



  template <typename Number>
  void
  EliminatedUnknowns<Number>::restore(Vector &vector) const
  {
    for (unsigned int k = 0; k < unknowns.size(); ++k)
      vector.local_element(unknowns[k]) = remembered[k];
  }



  template <typename Number>
  void
  EliminatedUnknowns<Number>::condense(Vector &forces) const
  {
    for (unsigned int k = 0; k < unknowns.size(); ++k)
      {
        Number      &eliminated = forces.local_element(unknowns[k]);
        const Number force      = eliminated;
        eliminated              = 0.;
        for (unsigned int j = row_starts[k]; j < row_starts[k + 1]; ++j)
          forces.local_element(entries[j].master) += entries[j].weight * force;
      }
  }



  template class EliminatedUnknowns<float>;
  template class EliminatedUnknowns<double>;
} // namespace ElastoPlastic
