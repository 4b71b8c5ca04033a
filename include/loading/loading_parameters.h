// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loading_loading_parameters_h
#define loading_loading_parameters_h

#include <deal.II/base/parameter_handler.h>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Loading".
  struct LoadingParameters
  {
    double       depth      = 0.01;
    unsigned int n_steps    = 1;
    double       final_time = 1;

    void
    add_parameters(ParameterHandler &prm);

    void
    check() const;
  };
} // namespace ElastoPlastic

#endif
