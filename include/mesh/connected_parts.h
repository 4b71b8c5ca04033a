// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_connected_parts_h
#define mesh_connected_parts_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/tria.h>

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
} // namespace ElastoPlastic

#endif
