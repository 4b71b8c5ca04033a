// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/pending/disjoint_sets.hpp>

#include <map>

#include "mesh/connected_parts.h"

namespace ElastoPlastic
{
  template <int dim>
  ConnectedParts<dim>::ConnectedParts(const Triangulation<dim> &mesh)
    : part_of_coarse_cell(mesh.n_cells(0))
  {
    boost::disjoint_sets_with_storage<> sets(mesh.n_cells(0));
    for (const auto &cell : mesh.cell_iterators_on_level(0))
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f))
          sets.union_set(cell->index(), cell->neighbor_index(f));

    std::map<unsigned int, unsigned int> numbers;
    for (const auto &cell : mesh.cell_iterators_on_level(0))
      {
        const auto [set, is_new] =
          numbers.emplace(sets.find_set(cell->index()), numbers.size());
        part_of_coarse_cell[cell->index()] = set->second;
        if (is_new)
          boxes.push_back(cell->bounding_box());
        else
          boxes[set->second].merge_with(cell->bounding_box());
      }
  }



  template <int dim>
  unsigned int
  ConnectedParts<dim>::part_of(
    const typename Triangulation<dim>::cell_iterator &cell) const
  {
    auto ancestor = cell;
    while (ancestor->level() > 0)
      ancestor = ancestor->parent();
    return part_of_coarse_cell[ancestor->index()];
  }



  template class ConnectedParts<2>;
  template class ConnectedParts<3>;
} // namespace ElastoPlastic
