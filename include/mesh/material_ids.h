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

  /// Sets the material id of each cell to the value of the expression @p text
  /// at its centre, rounded: now, and after each later change of the mesh. So a
  /// material id depends on the place and the size of a cell only, whatever
  /// rank it is on and whatever has been coarsened in between. That goes for
  /// the cells of all levels: a cell that has been divided keeps the id that it
  /// had.
  ///
  /// Collective, and so are all changes of a distributed @p triangulation from
  /// then on. @throws InputError naming the entry @p path, now or then, if the
  /// expression cannot be evaluated or its value is negative somewhere.
  template <int dim>
  void
  set_material_ids(const std::string  &path,
                   const std::string  &text,
                   Triangulation<dim> &triangulation);



  /// A warning that names those of the materials 0 to @p n_materials - 1 that
  /// no active cell consists of; empty if there are none. Collective.
  template <int dim>
  std::string
  warning_of_unused_materials(const Triangulation<dim> &triangulation,
                              const unsigned int        n_materials);



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
               "'Geometry/Material id' or, for a mesh file, 'Geometry/Material "
               "groups'.";
    throw InputError(message.str());
  }



  /// The same for all cells of all ranks. A single material stands for every
  /// id. Collective.
  template <int dim>
  void
  check_material_ids(const Triangulation<dim> &triangulation,
                     const unsigned int        n_materials);
} // namespace ElastoPlastic

#endif
