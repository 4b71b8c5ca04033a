// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_newton_parameters_h
#define solver_newton_parameters_h

#include <deal.II/base/parameter_handler.h>

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
} // namespace ElastoPlastic

#endif
