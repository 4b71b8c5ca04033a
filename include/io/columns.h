// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_columns_h
#define io_columns_h

#include "evaluation/indentation_test.h"
#include "evaluation/solve_result.h"
#include "io/table.h"

namespace ElastoPlastic
{
  /// The equilibria on the old and the new mesh under the same load; plastic
  /// work and dissipation of the second one are those of the way to it.
  struct MeshChange
  {
    const SolveResult &before;
    const SolveResult &after;
  };

  /// The columns of statistics.csv: a row per nonlinear solve.
  const Columns<SolveResult> &
  statistics_columns();

  /// The columns of history.csv: a row per converged load step.
  const Columns<SolveResult> &
  history_columns();

  /// The columns of mesh_changes.csv: a row per change of the mesh.
  const Columns<MeshChange> &
  mesh_change_columns();

  /// The columns of indentation.csv: a row per unloading.
  const Columns<UnloadingResult> &
  indentation_columns();
} // namespace ElastoPlastic

#endif
