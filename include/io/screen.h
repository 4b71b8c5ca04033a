// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_screen_h
#define io_screen_h

#include <deal.II/base/conditional_ostream.h>

#include <string>

#include "base/enum_names.h"
#include "solver/semismooth_newton.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// How much is printed; see the entry "Screen".
  enum class Verbosity
  {
    full,
    summary,
    quiet
  };

  template <>
  inline const EnumNames<Verbosity> enum_names<Verbosity> = {
    {"full", Verbosity::full},
    {"summary", Verbosity::summary},
    {"quiet", Verbosity::quiet}};



  /// What one nonlinear solve has found: a row of statistics.csv and, in part,
  /// of the table on the screen. Units are those of the input.
  struct SolveResult
  {
    unsigned int            step              = 0;
    double                  time              = 0;
    unsigned int            cycle             = 0;
    types::global_dof_index cells             = 0;
    types::global_dof_index dofs              = 0;
    unsigned int            newton_iterations = 0;
    unsigned int            linear_iterations = 0;
    unsigned int            active_nodes      = 0;
    double                  force             = 0;
    double                  depth             = 0;
    double                  residual          = 0;
    /// |force - reaction of the supports - tractions| / the largest sum of the
    /// magnitudes of all nodal forces so far
    double force_balance_error   = 0;
    double max_penetration       = 0;
    double complementarity_error = 0;
    double estimated_error       = 0;
    double wall_seconds          = 0;
    /// peak, all ranks together
    double memory_mb                     = 0;
    double max_hanging_penetration       = 0;
    double min_pressure                  = 0;
    double contact_area                  = 0;
    double max_pressure                  = 0;
    double energy                        = 0;
    double plastic_volume                = 0;
    double max_equivalent_plastic_strain = 0;
    double elastic_energy                = 0;
    /// what hardening has stored
    double hardening_energy = 0;
    /// of the load step; in history.csv since the virgin state, as is the work
    /// of the external forces, those of indenter and supports included
    double plastic_work  = 0;
    double dissipation   = 0;
    double external_work = 0;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &step &time &cycle &cells &dofs &newton_iterations
        &linear_iterations &active_nodes &force &depth &residual
          &force_balance_error &max_penetration &complementarity_error
            &estimated_error &wall_seconds &memory_mb &max_hanging_penetration
              &min_pressure &contact_area &max_pressure &energy &plastic_volume
                &max_equivalent_plastic_strain &elastic_energy &hardening_energy
                  &plastic_work &dissipation &external_work;
    }
  };



  /// Tells the user on the screen what is going on, from the first rank only,
  /// as much as the entry "Output/Screen" allows.
  class Screen
  {
  public:
    Screen(const MPI_Comm communicator, const Verbosity verbosity);

    /// Program, libraries, build and number of ranks.
    void
    print_banner(const unsigned int n_ranks);

    void
    begin_solve(const SolveResult &sizes);

    void
    newton_step(const NewtonStep &step);

    void
    end_solve(const SolveResult &result);

    /// A remark that only the full output shows.
    void
    remark(const std::string &text);

    /// Something unexpected that does not stop the program: one line on
    /// standard error, however quiet the program is to be.
    void
    warn(const std::string &text);

    /// For the table of times.
    ConditionalOStream &
    full_stream();

  private:
    ConditionalOStream full;
    ConditionalOStream summary;
    ConditionalOStream warnings;
  };
} // namespace ElastoPlastic

#endif
