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
  template <int n>
  void
  EliminatedUnknowns<dim, Number>::Rows<n>::add(
    const Line &line, const Utilities::MPI::Partitioner &layout)
  {
    unknowns.push_back(layout.global_to_local(line.index));
    for (const auto &[master, weight] : line.entries)
      {
        AssertThrow(is_local(master, layout), ExcInternalError());
        AssertDimension(layout.global_to_local(master + n - 1),
                        layout.global_to_local(master) + n - 1);
        entries.push_back(
          {layout.global_to_local(master), static_cast<Number>(weight)});
      }
    row_starts.push_back(entries.size());
    remembered.emplace_back();
  }



  template <int dim, typename Number>
  template <int n>
  void
  EliminatedUnknowns<dim, Number>::Rows<n>::expand(Number *const vector) const
  {
    for (unsigned int k = 0; k < unknowns.size(); ++k)
      {
        std::array<Number, n> sums{};
        for (unsigned int j = row_starts[k]; j < row_starts[k + 1]; ++j)
          for (unsigned int c = 0; c < n; ++c)
            sums[c] += entries[j].weight * vector[entries[j].master + c];
        for (unsigned int c = 0; c < n; ++c)
          remembered[k][c] = std::exchange(vector[unknowns[k] + c], sums[c]);
      }
  }



  template <int dim, typename Number>
  template <int n>
  void
  EliminatedUnknowns<dim, Number>::Rows<n>::restore(Number *const vector) const
  {
    for (unsigned int k = 0; k < unknowns.size(); ++k)
      for (unsigned int c = 0; c < n; ++c)
        vector[unknowns[k] + c] = remembered[k][c];
  }



  template <int dim, typename Number>
  template <int n>
  void
  EliminatedUnknowns<dim, Number>::Rows<n>::condense(Number *const forces) const
  {
    for (unsigned int k = 0; k < unknowns.size(); ++k)
      {
        std::array<Number, n> of_unknowns;
        for (unsigned int c = 0; c < n; ++c)
          of_unknowns[c] = std::exchange(forces[unknowns[k] + c], Number(0.));
        for (unsigned int j = row_starts[k]; j < row_starts[k + 1]; ++j)
          for (unsigned int c = 0; c < n; ++c)
            forces[entries[j].master + c] += entries[j].weight * of_unknowns[c];
      }
  }



  template <int dim, typename Number>
  bool
  EliminatedUnknowns<dim, Number>::is_of_node(const Line *const line,
                                              const Line *const end)
  {
    if (end - line < dim)
      return false;
    for (unsigned int c = 1; c < dim; ++c)
      {
        if (line[c].index != line->index + c ||
            line[c].entries.size() != line->entries.size())
          return false;
        for (unsigned int j = 0; j < line->entries.size(); ++j)
          if (line[c].entries[j].first != line->entries[j].first + c ||
              line[c].entries[j].second != line->entries[j].second)
            return false;
      }
    return true;
  }



  template <int dim, typename Number>
  void
  EliminatedUnknowns<dim, Number>::reinit(
    const AffineConstraints<double>   &constraints,
    const Utilities::MPI::Partitioner &layout)
  {
    of_nodes         = {};
    others           = {};
    const auto lines = constraints.get_lines();
    if (lines.empty())
      return;
    const Line *const end = &*lines.begin() + lines.size();
    for (const Line *line = &*lines.begin(); line != end;)
      {
        const bool is_node = is_of_node(line, end);
        if (is_local(line->index, layout))
          {
            if (is_node)
              of_nodes.add(*line, layout);
            else
              others.add(*line, layout);
          }
        line += is_node ? dim : 1;
      }
  }



  template <int dim, typename Number>
  void
  EliminatedUnknowns<dim, Number>::expand(Vector &vector) const
  {
    of_nodes.expand(vector.begin());
    others.expand(vector.begin());
  }



  template <int dim, typename Number>
  void
  EliminatedUnknowns<dim, Number>::restore(Vector &vector) const
  {
    of_nodes.restore(vector.begin());
    others.restore(vector.begin());
  }



  template <int dim, typename Number>
  void
  EliminatedUnknowns<dim, Number>::condense(Vector &forces) const
  {
    of_nodes.condense(forces.begin());
    others.condense(forces.begin());
  }



  template class EliminatedUnknowns<2, float>;
  template class EliminatedUnknowns<3, float>;
  template class EliminatedUnknowns<2, double>;
  template class EliminatedUnknowns<3, double>;
} // namespace ElastoPlastic
