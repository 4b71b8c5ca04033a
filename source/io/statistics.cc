// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "io/statistics.h"

namespace ElastoPlastic
{
  namespace
  {
    std::vector<std::string>
    reaction_columns(const std::vector<std::string> &names)
    {
      std::vector<std::string> columns = {"step", "time"};
      columns.insert(columns.end(), names.begin(), names.end());
      return columns;
    }



    IndentationPoint
    indentation_point(const SolveResult &r)
    {
      return {r.step, r.time, r.depth, r.force, r.contact_area};
    }
  } // namespace



  Statistics::Statistics(const MPI_Comm                        communicator,
                         const std::string                    &directory,
                         const std::vector<std::string>       &reaction_names,
                         const std::optional<IndentationTest> &indentation_test,
                         const Progress                       &progress)
    : communicator(communicator)
    , directory(directory)
    , statistics(communicator,
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
                 progress.statistics)
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
              progress.history)
    , reactions(communicator,
                directory + "/reactions.csv",
                reaction_columns(reaction_names),
                progress.reactions)
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
                   progress.mesh_changes)
    , indentation_test(indentation_test)
  {
    if (!this->indentation_test)
      return;
    this->indentation_test->resume(progress.unloading);
    if (progress.indentation > 0)
      open_indentation(progress.indentation);
  }



  Statistics::Progress
  Statistics::progress() const
  {
    return {statistics.n_rows(),
            history.n_rows(),
            reactions.n_rows(),
            mesh_changes.n_rows(),
            indentation ? indentation->n_rows() : 0,
            indentation_test ? indentation_test->progress() :
                               IndentationTest::Progress()};
  }



  void
  Statistics::write_to_disk() const
  {
    for (const CsvFile *table :
         {&statistics, &history, &reactions, &mesh_changes})
      table->write_to_disk();
    if (indentation)
      indentation->write_to_disk();
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
  Statistics::add_step(const SolveResult         &r,
                       const std::vector<double> &reaction_forces)
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

    std::vector<double> row = {static_cast<double>(r.step), r.time};
    row.insert(row.end(), reaction_forces.begin(), reaction_forces.end());
    reactions.add_row(row);

    if (indentation_test)
      add_unloading(indentation_test->add(indentation_point(r)));
  }



  void
  Statistics::finish()
  {
    if (indentation_test)
      add_unloading(indentation_test->finish());
  }



  void
  Statistics::open_indentation(const unsigned int n_rows)
  {
    indentation.emplace(communicator,
                        directory + "/indentation.csv",
                        std::vector<std::string>{"step",
                                                 "time",
                                                 "max_depth",
                                                 "max_force",
                                                 "contact_area",
                                                 "modelled_part",
                                                 "stiffness",
                                                 "exponent",
                                                 "final_depth",
                                                 "hardness",
                                                 "reduced_modulus",
                                                 "contact_depth",
                                                 "tip_area",
                                                 "tip_hardness",
                                                 "tip_reduced_modulus"},
                        n_rows);
  }



  void
  Statistics::add_unloading(const std::optional<UnloadingResult> &result)
  {
    if (!result)
      return;
    if (!indentation)
      open_indentation(0);
    const UnloadingResult &r    = *result;
    const double           area = r.maximum.contact_area;
    indentation->add_row({static_cast<double>(r.maximum.step),
                          r.maximum.time,
                          r.maximum.depth,
                          r.maximum.force,
                          area,
                          r.modelled_part,
                          r.stiffness,
                          r.law.exponent,
                          r.law.final_depth,
                          r.hardness(area),
                          r.reduced_modulus(area),
                          r.contact_depth,
                          r.tip_area,
                          r.hardness(r.tip_area),
                          r.reduced_modulus(r.tip_area)});
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
    if (indentation_test)
      indentation_test->change_mesh(indentation_point(before),
                                    indentation_point(after));
  }
} // namespace ElastoPlastic
