// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "io/statistics.h"

namespace ElastoPlastic
{
  Statistics::Statistics(const MPI_Comm     communicator,
                         const std::string &directory,
                         const Sizes       &sizes)
    : statistics(communicator,
                 directory + "/statistics.csv",
                 {"step",
                  "cycle",
                  "cells",
                  "dofs",
                  "newton_iterations",
                  "linear_iterations",
                  "active_nodes",
                  "force",
                  "depth",
                  "residual",
                  "force_balance_error",
                  "max_penetration",
                  "complementarity_error",
                  "estimated_error",
                  "wall_seconds",
                  "memory_mb",
                  "max_hanging_penetration",
                  "min_pressure",
                  "contact_area",
                  "max_pressure",
                  "energy"},
                 sizes.statistics)
    , history(communicator,
              directory + "/history.csv",
              {"step",
               "time",
               "depth",
               "force",
               "contact_area",
               "max_pressure",
               "active_nodes",
               "plastic_volume",
               "max_equivalent_plastic_strain",
               "cells",
               "dofs",
               "newton_iterations",
               "linear_iterations",
               "estimated_error",
               "wall_seconds",
               "elastic_energy",
               "hardening_energy",
               "plastic_work",
               "dissipation",
               "external_work"},
              sizes.history)
    , mesh_changes(communicator,
                   directory + "/mesh_changes.csv",
                   {"step",
                    "time",
                    "cells_before",
                    "cells",
                    "dofs",
                    "force_before",
                    "force",
                    "depth_before",
                    "depth",
                    "elastic_energy_before",
                    "elastic_energy",
                    "hardening_energy_before",
                    "hardening_energy",
                    "plastic_volume_before",
                    "plastic_volume",
                    "max_equivalent_plastic_strain_before",
                    "max_equivalent_plastic_strain",
                    "plastic_work",
                    "dissipation"},
                   sizes.mesh_changes)
  {}



  Statistics::Sizes
  Statistics::sizes() const
  {
    return {statistics.n_rows(), history.n_rows(), mesh_changes.n_rows()};
  }



  void
  Statistics::add_solve(const SolveResult &r)
  {
    statistics.add_row({static_cast<double>(r.step),
                        static_cast<double>(r.cycle),
                        static_cast<double>(r.cells),
                        static_cast<double>(r.dofs),
                        static_cast<double>(r.newton_iterations),
                        static_cast<double>(r.linear_iterations),
                        static_cast<double>(r.active_nodes),
                        r.force,
                        r.depth,
                        r.residual,
                        r.force_balance_error,
                        r.max_penetration,
                        r.complementarity_error,
                        r.estimated_error,
                        r.wall_seconds,
                        r.memory_mb,
                        r.max_hanging_penetration,
                        r.min_pressure,
                        r.contact_area,
                        r.max_pressure,
                        r.energy});
  }



  void
  Statistics::add_step(const SolveResult &r)
  {
    history.add_row({static_cast<double>(r.step),
                     r.time,
                     r.depth,
                     r.force,
                     r.contact_area,
                     r.max_pressure,
                     static_cast<double>(r.active_nodes),
                     r.plastic_volume,
                     r.max_equivalent_plastic_strain,
                     static_cast<double>(r.cells),
                     static_cast<double>(r.dofs),
                     static_cast<double>(r.newton_iterations),
                     static_cast<double>(r.linear_iterations),
                     r.estimated_error,
                     r.wall_seconds,
                     r.elastic_energy,
                     r.hardening_energy,
                     r.plastic_work,
                     r.dissipation,
                     r.external_work});
  }



  void
  Statistics::add_mesh_change(const SolveResult &before,
                              const SolveResult &after)
  {
    mesh_changes.add_row({static_cast<double>(after.step),
                          after.time,
                          static_cast<double>(before.cells),
                          static_cast<double>(after.cells),
                          static_cast<double>(after.dofs),
                          before.force,
                          after.force,
                          before.depth,
                          after.depth,
                          before.elastic_energy,
                          after.elastic_energy,
                          before.hardening_energy,
                          after.hardening_energy,
                          before.plastic_volume,
                          after.plastic_volume,
                          before.max_equivalent_plastic_strain,
                          after.max_equivalent_plastic_strain,
                          after.plastic_work,
                          after.dissipation});
  }
} // namespace ElastoPlastic
