// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef app_bounds_h
#define app_bounds_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/types.h>

#include <memory>
#include <string>

#include "contact_run/guaranteed_error.h"
#include "problem/model.h"

// What the program asks of bounds/. A program can be built without (CMake's
// option STRICT_BOUNDS): then source/app/without_bounds.cc stands in for
// with_bounds.cc, and what cannot be done ends with an InputError that says so.

namespace ElastoPlastic
{
  /// What is strict: limit loads between two bounds, and bounds of errors.
  template <int dim>
  struct StrictBounds
  {
    /// Finds the limit load that @p parameters ask for; see
    /// LimitLoadAnalysis::run().
    static void
    find_limit_load(const Model<dim> &model,
                    const Parameters &parameters,
                    const MPI_Comm    communicator,
                    const bool        overwrite);

    /// Looks at what can be wrong with that; see LimitLoadAnalysis::check().
    /// @return the number of cells of the first mesh
    static types::global_cell_index
    check_limit_load(const Model<dim> &model,
                     const Parameters &parameters,
                     const MPI_Comm    communicator);

    /// See MakeGuaranteedError.
    static std::unique_ptr<GuaranteedError<dim>>
    make_error_bound(const DiscreteBody<dim> &body,
                     const Parameters        &parameters,
                     Log                     &log);

    /// A perfectly plastic body must have stresses in equilibrium with the
    /// load_in_question() that satisfy the yield condition: it is compared with
    /// the bounds of the limit load. A warning says why, if there are no such
    /// bounds. @throws EquilibriumError if the load is not safe.
    static void
    require_safe_load(const Model<dim> &model,
                      const Parameters &parameters,
                      const MPI_Comm    communicator);

    /// What the first of the coarse meshes that require_safe_load() takes says
    /// about that, as a clause; empty where no load is in question. Collective.
    /// @throws EquilibriumError if the load is certainly not safe.
    static std::string
    first_look_at_load(const Model<dim> &model,
                       const Parameters &parameters,
                       const MPI_Comm    communicator);
  };
} // namespace ElastoPlastic

#endif
