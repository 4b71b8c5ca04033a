// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_material_ids_h
#define mesh_material_ids_h

#include <deal.II/grid/tria.h>

#include <sstream>
#include <string>

#include "base/exceptions.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Set the material ids of all cells of all levels, now and after each later
  /// change of the mesh: up to @p level the value of the expression @p text at
  /// the cell's centre, rounded; beyond it that of the parent. So a material
  /// id depends on the place of a cell only, whatever rank it is on and
  /// whatever has been coarsened in between.
  ///
  /// Collective. @throws InputError naming the entry @p path if the expression
  /// cannot be evaluated or its value is negative somewhere.
  template <int dim>
  void
  set_material_ids(const std::string  &path,
                   const std::string  &text,
                   const int           level,
                   Triangulation<dim> &triangulation);



  /// @throws InputError, on this rank, if @p cell is of a material that there
  /// is not.
  template <typename CellAccessor>
  void
  check_material_id(const CellAccessor &cell, const unsigned int n_materials)
  {
    if (cell.material_id() < n_materials)
      return;
    std::ostringstream message;
    message << "The cell with the centre (" << cell.center()
            << ") has the material id " << cell.material_id()
            << ", but the entries of 'Material' describe " << n_materials
            << " materials: 0 to " << n_materials - 1
            << ". Give one value for each material there, or change "
               "'Geometry/Material id'.";
    throw InputError(message.str());
  }
} // namespace ElastoPlastic

#endif
