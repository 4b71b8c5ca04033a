// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef safe_load_h
#define safe_load_h

#include <deal.II/base/mpi.h>

#include <string>

#include "base/exceptions.h"
#include "evaluation/solve_result.h"
#include "io/parameters.h"
#include "model/model.h"

namespace ElastoPlastic
{
  /// Johnson's condition of a safe load, (1.14) in @cite johnson_1978: a
  /// perfectly plastic body must have stresses in equilibrium with the force of
  /// the indenter that satisfy the yield condition. Where the equilibrium
  /// method can look for them (in two dimensions, without friction), the
  /// largest force that is prescribed, or if there is no indenter, the largest
  /// of the tractions and body forces, is compared with the bounds of the limit
  /// load; a warning says why, if there are no such bounds. Otherwise, nothing
  /// is done.
  /// @throws EquilibriumError if the force is not safe.
  template <int dim>
  void
  require_safe_load(const Model<dim> &model,
                    const Parameters &parameters,
                    const MPI_Comm    communicator);



  /// What the first of the coarse meshes that require_safe_load() takes says
  /// about that, as a clause; empty where nothing is done. Collective.
  /// @throws EquilibriumError if the force is certainly not safe.
  template <int dim>
  std::string
  first_look_at_load(const Model<dim> &model,
                     const Parameters &parameters,
                     const MPI_Comm    communicator);



  /// What a load step asks for at its end: the force on the indenter, 0 if its
  /// depth is given.
  struct AskedFor
  {
    double force;
    double time;
  };

  /// A step has failed with @p error, however short it was made. If the body's
  /// materials stop hardening, it has a limit load; if also force or tractions
  /// were to grow since the @p last equilibrium, then that has been reached.
  /// @throws EquilibriumError then, @p error otherwise
  template <int dim>
  [[noreturn]] void
  give_up_step(const ConvergenceError &error,
               const Model<dim>       &model,
               const AskedFor         &step,
               const bool              tractions_grow,
               const SolveResult      &last);
} // namespace ElastoPlastic

#endif
