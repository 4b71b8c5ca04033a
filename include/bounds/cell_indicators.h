// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_cell_indicators_h
#define bounds_cell_indicators_h

#include <deal.II/lac/vector.h>

#include <vector>

#include "bounds/mesh/split_mesh.h"
#include "bounds/mesh/tetrahedral_mesh.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What decides on the refinement of quadrilaterals: the square root of the
  /// sum of what the first rank knows of their triangles, @p of_triangles of
  /// @p mesh; negative numbers count as zero. Every rank receives the values of
  /// its own active cells.
  Vector<float>
  cell_indicators(const SplitMesh           &mesh,
                  const std::vector<double> &of_triangles,
                  const Triangulation<2>    &triangulation);

  /// The same for hexahedra and their tetrahedra.
  Vector<float>
  cell_indicators(const TetrahedralMesh     &mesh,
                  const std::vector<double> &of_tetrahedra,
                  const Triangulation<3>    &triangulation);
} // namespace ElastoPlastic

#endif
