// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_connected_parts_h
#define mesh_connected_parts_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/tria.h>

#include <boost/pending/disjoint_sets.hpp>

#include <map>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The parts of a body whose cells are connected through faces. Corners and
  /// edges connect nothing: a continuum passes no force through them.
  /// Refinement changes nothing here, so that all ranks know all parts.
  template <int dim>
  class ConnectedParts
  {
  public:
    explicit ConnectedParts(const Triangulation<dim> &mesh);

    unsigned int
    size() const
    {
      return boxes.size();
    }

    /// The number of the part that @p cell, of any level, belongs to.
    unsigned int
    part_of(const typename Triangulation<dim>::cell_iterator &cell) const;

    /// A box around the coarse cells of a part.
    const BoundingBox<dim> &
    box(const unsigned int part) const
    {
      return boxes[part];
    }

  private:
    std::vector<unsigned int>     part_of_coarse_cell; ///< by index
    std::vector<BoundingBox<dim>> boxes;
  };



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
} // namespace ElastoPlastic

#endif
