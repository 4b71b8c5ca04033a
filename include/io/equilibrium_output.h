// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_equilibrium_output_h
#define io_equilibrium_output_h

#include <deal.II/base/data_out_base.h>

#include <string>
#include <utility>
#include <vector>

#include "equilibrium/limit_load.h"

namespace ElastoPlastic
{
  /// Writes what ParaView shows of a limit load analysis, on one rank: the
  /// files limit_load-*.vtu with one triangle for each third, nothing smoothed,
  /// and limit_load.pvd that lists them.
  class EquilibriumOutput
  {
  public:
    explicit EquilibriumOutput(const std::string &directory);

    /// @p cycle numbers the file. @throws FileError
    void
    write(const PlaneBody   &body,
          const LimitLoad   &bounds,
          const unsigned int cycle);

  private:
    const std::string                           directory;
    std::vector<std::pair<double, std::string>> records;
  };
} // namespace ElastoPlastic

#endif
