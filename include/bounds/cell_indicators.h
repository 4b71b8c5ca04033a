// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_cell_indicators_h
#define bounds_cell_indicators_h

#include <deal.II/lac/vector.h>

#include <vector>

#include "bounds/mesh/split_mesh.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What decides on the refinement of cells: the square root of the sum of
  /// what the first rank knows of their simplices, @p of_simplices of @p mesh;
  /// negative numbers count as zero. Every rank receives the values of its own
  /// active cells. Collective.
  template <int dim>
  Vector<float>
  cell_indicators(const SplitMesh<dim>      &mesh,
                  const std::vector<double> &of_simplices,
                  const Triangulation<dim>  &triangulation);
} // namespace ElastoPlastic

#endif
