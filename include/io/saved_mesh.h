// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_saved_mesh_h
#define io_saved_mesh_h

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>

#include <string>
#include <vector>

#include "mechanics/ghosted_copy.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Numbers for each locally owned cell, equally many, by the index of the
  /// active cell.
  using CellValues = std::vector<std::vector<double>>;

  /// Writes the active cells of @p triangulation, with @p values, into files
  /// whose names begin with @p name: one of each rank, which may be read by any
  /// number of ranks. (Triangulation::save() cannot be used: on a full disk,
  /// p4est aborts and MPI's shared file pointers wait for ever.)
  ///
  /// A file holds, in the representation of the machine, the number of cells
  /// and that of values of each; the CellIds; and, cell by cell, the centre and
  /// the values.
  ///
  /// Collective. @throws FileError
  template <int dim>
  void
  save_mesh(const parallel::distributed::Triangulation<dim> &triangulation,
            const CellValues                                &values,
            const std::string                               &name);

  /// Refines @p triangulation, which is the coarse mesh of the one saved, until
  /// it has the same cells.
  ///
  /// Collective. @return the values of the cells. @throws InputError if they
  /// are the cells of another mesh, FileError
  template <int dim>
  CellValues
  load_mesh(parallel::distributed::Triangulation<dim> &triangulation,
            const std::string                         &name);

  /// Adds to the numbers of each cell those of @p fields at its unknowns, field
  /// by field. Collective.
  template <int dim>
  void
  append_fields(CellValues                      &values,
                const std::vector<VectorType *> &fields,
                const DoFHandler<dim>           &dof_handler);

  /// Takes them off the end again, and puts them into @p fields, which have the
  /// layout of the unknowns.
  template <int dim>
  void
  take_fields(CellValues                      &values,
              const std::vector<VectorType *> &fields,
              const DoFHandler<dim>           &dof_handler);
} // namespace ElastoPlastic

#endif
