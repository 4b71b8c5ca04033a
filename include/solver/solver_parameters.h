// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_solver_parameters_h
#define solver_solver_parameters_h

#include <deal.II/base/parameter_handler.h>

#include "base/enum_names.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// The entries of the section "Nonlinear solver".
  struct NewtonParameters
  {
    double       tolerance                = 1e-10;
    unsigned int maximum_iterations       = 100;
    double       loosest_linear_reduction = 1e-2;

    void
    add_parameters(ParameterHandler &prm);

    void
    check() const;
  };



  /// What preconditions the Krylov method; see the entry "Type".
  enum class Preconditioner
  {
    multigrid, ///< geometric
    amg,       ///< algebraic
    direct     ///< a factorisation
  };

  template <>
  inline const EnumNames<Preconditioner> enum_names<Preconditioner> = {
    {"multigrid", Preconditioner::multigrid},
    {"AMG", Preconditioner::amg},
    {"direct", Preconditioner::direct}};



  /// The entries of the section "Linear solver".
  struct LinearSolverParameters
  {
    Preconditioner type               = Preconditioner::multigrid;
    unsigned int   maximum_iterations = 1000;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws InputError
    void
    check() const;
  };
} // namespace ElastoPlastic

#endif
