// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_local_refinement_h
#define mesh_local_refinement_h

#include <deal.II/grid/tria.h>

#include <string>

#include "mesh/geometry.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What 32 bits can number of the unknowns of quadratic elements in three
  /// dimensions, and what all machines together have room for, with two
  /// kilobytes for a cell, which is less than any problem takes. Collective.
  double
  max_n_cells(const MPI_Comm communicator);

  /// @throws InputError if @p n_cells are more than @p max_n_cells: @p value of
  /// the entry @p path asks for at least so many.
  void
  check_n_cells(const std::string &path,
                const unsigned int value,
                const double       n_cells,
                const double       max_n_cells);

  /// The local refinements that @p parameters ask for. Collective.
  /// @throws InputError as check_n_cells() does, before there are too many.
  template <int dim>
  void
  refine_locally(const GeometryParameters &parameters,
                 const double              max_n_cells,
                 Triangulation<dim>       &triangulation);
} // namespace ElastoPlastic

#endif
