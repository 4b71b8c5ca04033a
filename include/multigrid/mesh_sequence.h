// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef multigrid_mesh_sequence_h
#define multigrid_mesh_sequence_h

#include <deal.II/distributed/tria.h>

#include <memory>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// @p mesh (the last one) and the meshes it has been refined from: level by
  /// level without the finest cells, wherever they are. The first one is the
  /// finest of those that have at most @p n_coarse_cells cells, or the one that
  /// p4est starts from. Each has its own partition, with the same number of
  /// cells for all ranks. @p mesh must outlive the others.
  ///
  /// This is deal.II's
  /// MGTransferGlobalCoarseningTools::create_geometric_coarsening_sequence(),
  /// but it coarsens in p4est, where it costs next to nothing, instead of
  /// copying the mesh itself first, which takes longer than solving.
  template <int dim>
  std::vector<std::shared_ptr<const Triangulation<dim>>>
  mesh_sequence(const parallel::distributed::Triangulation<dim> &mesh,
                const unsigned int n_coarse_cells);
} // namespace ElastoPlastic

#endif
