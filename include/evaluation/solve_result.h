// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_solve_result_h
#define evaluation_solve_result_h

#include <deal.II/base/types.h>

namespace ElastoPlastic
{
  using namespace dealii;

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
} // namespace ElastoPlastic

#endif
