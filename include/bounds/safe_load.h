// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_safe_load_h
#define bounds_safe_load_h

#include <deal.II/base/mpi.h>

#include <string>

#include "base/exceptions.h"
#include "evaluation/solve_result.h"
#include "input/parameters.h"
#include "problem/model.h"

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



  /// A load step that has failed, however short it was made.
  template <int dim>
  struct FailedStep
  {
    const Model<dim> &model;
    bool              is_single; ///< there are no others
    unsigned int      number;
    double            begin, end; ///< times
    /// On the indenter at the end, 0 if its depth is given.
    double force;
    /// Whether the tractions were to grow in the step.
    bool tractions_grow;
  };

  /// @p step has failed with @p error, after the equilibrium @p last. If the
  /// body's materials stop hardening, it has a limit load; if also force or
  /// tractions were to grow, then that has been reached.
  /// @throws EquilibriumError then, ConvergenceError otherwise
  template <int dim>
  [[noreturn]] void
  give_up_step(const ConvergenceError &error,
               const FailedStep<dim>  &step,
               const SolveResult      &last);
} // namespace ElastoPlastic

#endif
