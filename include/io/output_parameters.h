// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_output_parameters_h
#define io_output_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Output".
  struct OutputParameters
  {
    std::string directory = "output";
    std::string fields    = "every cycle";
    std::string screen    = "full";
    /// Load steps from one checkpoint to the next; 0: on request only.
    unsigned int checkpoint_interval = 1;

    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace ElastoPlastic

#endif
