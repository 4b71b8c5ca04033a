// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mesh_cut_cells_h
#define bounds_mesh_cut_cells_h

#include <deal.II/base/point.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <vector>

// How the quadrilaterals and hexahedra of a mesh are cut into simplices, and
// sent to the first rank.

namespace ElastoPlastic
{
  using namespace dealii;


  /// What tells the corners of simplices apart, for all cells around them: a
  /// vertex of the mesh of cells by its number, four times, and the centre of
  /// a quadrilateral face by those of its vertices, sorted.
  using CutVertex = std::array<types::global_dof_index, 4>;



  /// A corner of a facet.
  template <int dim>
  struct FacetCorner
  {
    CutVertex  key;
    Point<dim> position;
    Point<dim> unit_position; ///< in the unit cell

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &key &position &unit_position;
    }
  };



  /// What is joined to the centre of a cell to make a simplex.
  template <int dim>
  struct Facet
  {
    std::array<FacetCorner<dim>, dim> corners;
    types::boundary_id                boundary_id;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &corners &boundary_id;
    }
  };



  template <int dim>
  struct CutCell
  {
    CellId                  id;
    types::material_id      material_id;
    Point<dim>              centre;
    std::vector<Facet<dim>> facets;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &id &material_id &centre &facets;
    }
  };



  /// The cells of all ranks, on the first of them, in the order of their
  /// numbers. Collective.
  template <int dim>
  std::vector<CutCell<dim>>
  gather_cut_cells(const Triangulation<dim> &triangulation);
} // namespace ElastoPlastic

#endif
