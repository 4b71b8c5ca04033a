// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/compatibility.h"
#include "base/ghost_values.h"
#include "multigrid/level_matching.h"
#include "multigrid/two_level_transfer.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A vector for the locally owned indices and those in @p entries.
    template <typename Entries>
    LevelVector
    vector_for(const IndexSet &owned,
               const Entries  &entries,
               const MPI_Comm  communicator)
    {
      std::vector<types::global_dof_index> foreign;
      for (const auto &entry : entries)
        if (!owned.is_element(entry.first))
          foreign.push_back(entry.first);
      std::sort(foreign.begin(), foreign.end());
      IndexSet ghosts(owned.size());
      ghosts.add_indices(foreign.begin(),
                         std::unique(foreign.begin(), foreign.end()));
      return LevelVector(owned, ghosts, communicator);
    }
  } // namespace



  template <int dim>
  TwoLevelTransfer<dim>::TwoLevelTransfer(const DoFHandler<dim> &fine,
                                          const Constraints &fine_constraints,
                                          const DoFHandler<dim> &coarse,
                                          const Constraints &coarse_constraints)
  {
    LevelMatching<dim> matching(fine,
                                fine_constraints,
                                coarse,
                                coarse_constraints);

    const MPI_Comm communicator = communicator_of(coarse);
    coarse_values =
      vector_for(coarse.locally_owned_dofs(), matching.entries, communicator);
    const auto &layout = *coarse_values.get_partitioner();
    std::vector<typename NodalInterpolation<dim, float>::Entry> entries;
    for (unsigned int k = 0; k < matching.rows.size(); ++k)
      {
        entries.clear();
        for (unsigned int e = matching.row_starts[k];
             e < matching.row_starts[k + 1];
             ++e)
          entries.push_back({layout.global_to_local(matching.entries[e].first),
                             matching.entries[e].second});
        interpolation.add(matching.rows[k], entries);
      }
    interpolation.finish();

    coarse_cell_values =
      vector_for(OwnedCells<dim>(coarse.get_triangulation()).global_indices(),
                 matching.parents,
                 communicator);
    parents.reserve(matching.parents.size());
    for (const auto &[cell, share] : matching.parents)
      parents.push_back(
        {coarse_cell_values.get_partitioner()->global_to_local(cell), share});
  }



  template <int dim>
  void
  TwoLevelTransfer<dim>::prolongate_and_add(LevelVector       &fine,
                                            const LevelVector &coarse) const
  {
    coarse_values.copy_locally_owned_data_from(coarse);
    const GhostValues ghosts(coarse_values);
    float *const      values = fine.begin();
    interpolation.interpolate(coarse_values.begin(),
                              [&](const unsigned int i, const float value) {
                                values[i] += value;
                              });
  }



  template <int dim>
  void
  TwoLevelTransfer<dim>::restrict_and_add(LevelVector       &coarse,
                                          const LevelVector &fine) const
  {
    coarse_values             = 0.f;
    const float *const values = fine.begin();
    interpolation.add_transpose(coarse_values.begin(),
                                [&](const unsigned int i) {
                                  return values[i];
                                });
    coarse_values.compress(VectorOperation::add);
    for (unsigned int i = 0; i < coarse.locally_owned_size(); ++i)
      coarse.local_element(i) += coarse_values.local_element(i);
  }



  // A row with one entry 1 belongs to a node that both levels have. If that of
  // the coarse level is owned by another rank, compress() takes it there.
  template <int dim>
  void
  TwoLevelTransfer<dim>::inject(LevelVector       &coarse,
                                const LevelVector &fine) const
  {
    coarse_values = 0.f;
    interpolation.for_each_copy(
      [&](const unsigned int i, const unsigned int j) {
        coarse_values.local_element(j) = fine.local_element(i);
      });
    coarse_values.compress(VectorOperation::add);
    coarse.copy_locally_owned_data_from(coarse_values);
  }



  template <int dim>
  void
  TwoLevelTransfer<dim>::average_cells(LevelVector       &coarse,
                                       const LevelVector &fine) const
  {
    coarse_cell_values = 0.f;
    for (unsigned int cell = 0; cell < parents.size(); ++cell)
      coarse_cell_values.local_element(parents[cell].index) +=
        parents[cell].share * fine.local_element(cell);
    coarse_cell_values.compress(VectorOperation::add);
    coarse = coarse_cell_values;
  }



  template class TwoLevelTransfer<2>;
  template class TwoLevelTransfer<3>;
} // namespace ElastoPlastic
