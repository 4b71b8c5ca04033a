// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/vectorization.h>

#include <cstdio>
#include <iostream>

#include "base/simd.h"
#include "base/version.h"
#include "output/log.h"

namespace ElastoPlastic
{
  std::string
  versions(const unsigned int n_ranks, const std::string &prefix)
  {
    return prefix + "ElastoPlasticContact " + ELASTO_PLASTIC_CONTACT_VERSION +
           " (" + ELASTO_PLASTIC_CONTACT_REVISION + "), " +
           ELASTO_PLASTIC_CONTACT_BUILD_TYPE + " build\n" + prefix +
           "deal.II " + DEAL_II_PACKAGE_VERSION + ", " +
           std::to_string(Simd<double>::size()) +
           " number(s) per SIMD batch, " + std::to_string(n_ranks) +
           " MPI rank(s)\n";
  }



  namespace
  {
    /// printf into a string.
    template <typename... Values>
    std::string
    format(const char *const pattern, const Values... values)
    {
      std::string text(std::snprintf(nullptr, 0, pattern, values...) + 1, '\0');
      std::snprintf(text.data(), text.size(), pattern, values...);
      text.pop_back();
      return text;
    }
  } // namespace



  Log::Log(const MPI_Comm communicator, const Verbosity verbosity)
    : full(std::cout,
           verbosity == Verbosity::full &&
             Utilities::MPI::this_mpi_process(communicator) == 0)
    , summary(std::cout,
              verbosity == Verbosity::summary &&
                Utilities::MPI::this_mpi_process(communicator) == 0)
    , warnings(std::cerr, Utilities::MPI::this_mpi_process(communicator) == 0)
  {}



  void
  Log::print_banner(const unsigned int n_ranks)
  {
    full << versions(n_ranks) << std::flush;
  }



  void
  Log::begin_solve(const SolveResult &sizes)
  {
    full << format("\nStep %u, t = %.6g, cycle %u: %llu cells, %llu unknowns\n",
                   sizes.step,
                   sizes.time,
                   sizes.cycle,
                   static_cast<unsigned long long>(sizes.cells),
                   static_cast<unsigned long long>(sizes.dofs))
         << "  step  active         energy   residual  linear  length"
         << std::endl;
  }



  void
  Log::newton_step(const NewtonStep &step)
  {
    full << format("  %4u  %6u %14.8e  %9.3e  %6u  %6.4f%s%s",
                   step.iteration,
                   step.n_active,
                   step.energy,
                   step.residual,
                   step.linear_iterations,
                   step.step_length,
                   step.active_set_changed ? "  set changed" : "",
                   step.feasible ? "  feasible" : "")
         << std::endl;
  }



  void
  Log::end_solve(const SolveResult &r)
  {
    full
      << format(
           "  depth %.10g, force %.10g, contact area %.6g, largest pressure %.6g, "
           "plastic volume %.6g\n"
           "  force balance %.1e, penetration %.1e (edge %.1e, hanging nodes "
           "%.1e), complementarity %.1e; %.2f s, %.0f MB",
           r.depth,
           r.force,
           r.contact_area,
           r.max_pressure,
           r.plastic_volume,
           r.force_balance_error,
           r.max_penetration,
           r.edge_penetration,
           r.max_hanging_penetration,
           r.complementarity_error,
           r.wall_seconds,
           r.memory_mb)
      << std::endl;
    table_row(
      "step cycle cells dofs active_nodes force depth contact_area "
      "max_pressure plastic_volume",
      format("%u %u %llu %llu %u %.12g %.12g %.12g %.12g %.12g",
             r.step,
             r.cycle,
             static_cast<unsigned long long>(r.cells),
             static_cast<unsigned long long>(r.dofs),
             r.active_nodes,
             r.force,
             r.depth,
             r.contact_area,
             r.max_pressure,
             r.plastic_volume));
  }



  void
  Log::table_row(const std::string &names, const std::string &row)
  {
    if (!table_has_begun)
      summary << names << '\n';
    table_has_begun = true;
    summary << row << std::endl;
  }



  void
  Log::warn_once(const std::string &text)
  {
    if (said.insert(text).second)
      warn(text);
  }
} // namespace ElastoPlastic
