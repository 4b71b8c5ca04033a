// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef safe_load_h
#define safe_load_h

#include <deal.II/base/mpi.h>

#include "io/parameters.h"
#include "model/model.h"

namespace ElastoPlastic
{
  /// Johnson's condition of a safe load, (1.14) in @cite johnson_1978: a
  /// perfectly plastic body must have stresses in equilibrium with the force of
  /// the indenter that satisfy the yield condition. Where the equilibrium
  /// method can look for them (plane strain and plane stress, no tractions),
  /// the largest force that is prescribed is compared with the bounds of the
  /// limit load; a warning says why, if there are no such bounds. Otherwise,
  /// nothing is done.
  /// @throws EquilibriumError if the force is not safe.
  template <int dim>
  void
  require_safe_load(const Model<dim> &model,
                    const Parameters &parameters,
                    const MPI_Comm    communicator);
} // namespace ElastoPlastic

#endif
