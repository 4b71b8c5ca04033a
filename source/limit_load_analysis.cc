// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/exceptions.h"
#include "base/throw_together.h"
#include "equilibrium/cell_indicators.h"
#include "equilibrium/stress_check.h"
#include "io/output_directory.h"
#include "limit_load_analysis.h"
#include "mesh/body_size.h"
#include "mesh/material_ids.h"
#include "mesh/refinement.h"

namespace ElastoPlastic
{
  namespace
  {
    const std::vector<std::string> limit_load_columns = {"cycle",
                                                         "cells",
                                                         "triangles",
                                                         "lower_bound",
                                                         "upper_bound",
                                                         "relative_difference",
                                                         "lower_iterations",
                                                         "upper_iterations",
                                                         "stress_error",
                                                         "divergence",
                                                         "wall_seconds"};



    void
    check_is_perfect(const std::vector<Material<double>> &materials)
    {
      for (const Material<double> &material : materials)
        if (!std::isfinite(material.yield_radius) || !is_perfect(material))
          throw InputError(
            "Analysis",
            "limit load",
            "only a body of perfectly plastic materials has a limit load that "
            "this analysis can find. Set 'Material/Law = perfectly plastic' "
            "with a yield stress for each material.");
    }
  } // namespace



  LimitLoadAnalysis::LimitLoadAnalysis(const Parameters &parameters,
                                       const MPI_Comm    communicator)
    : parameters(parameters)
    , communicator(communicator)
    , first_rank(Utilities::MPI::this_mpi_process(communicator) == 0)
    , screen(communicator, parameters.output.screen)
    , output(parameters.output.directory, "limit_load", "velocity")
    , triangulation(communicator)
    , boundary_names(make_mesh(parameters.geometry, triangulation))
    , boundary_conditions(parameters.boundary_conditions, boundary_names)
    , gap_function(parameters.indenter,
                   highest_point(triangulation,
                                 boundary_conditions.ids(
                                   BoundaryConditionType::contact)))
  {
    const auto materials = parameters.material.materials();
    check_is_perfect(materials);
    if (materials.size() > 1)
      throw_together(communicator, [&]() {
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned())
            check_material_id(*cell, materials.size());
      });
  }



  void
  LimitLoadAnalysis::run(const bool overwrite)
  {
    screen.print_banner(Utilities::MPI::n_mpi_processes(communicator));
    prepare_output_directory(communicator,
                             parameters.output.directory,
                             overwrite,
                             parameters.effective_input);
    CsvFile table(communicator,
                  parameters.output.directory + "/limit_load.csv",
                  limit_load_columns);
    while (true)
      {
        solve(table);
        if (!mark_next_mesh())
          break;
        triangulation.execute_coarsening_and_refinement();
        ++cycle;
      }
    screen.remark("Results are in " + parameters.output.directory);
  }



  PlaneBody
  LimitLoadAnalysis::make_body() const
  {
    return make_plane_body(
      make_split_mesh(triangulation),
      boundary_conditions,
      parameters.material.materials(),
      parameters.discretization.strain_model().kinematics,
      [this](const Point<2> &x) { return gap_function.value(x); },
      0.);
  }



  // The work of the first rank, while the others wait for its results.
  void
  LimitLoadAnalysis::solve(CsvFile &table)
  {
    const Timer     timer;
    const PlaneBody body = make_body();

    std::vector<double> row(limit_load_columns.size());
    LimitLoad           bounds;
    throw_together(communicator, [&]() {
      if (first_rank)
        {
          bounds             = bound_limit_load(body);
          const double error = require_admissible(body, bounds.stress);
          const double lower = bounds.stress.force,
                       upper = bounds.velocity.force;
          row                = {static_cast<double>(cycle),
                                static_cast<double>(body.mesh.cells.size()),
                                static_cast<double>(body.mesh.triangles.size()),
                                lower,
                                upper,
                                (upper - lower) / lower,
                                static_cast<double>(bounds.stress.n_iterations),
                                static_cast<double>(bounds.velocity.n_iterations),
                                error,
                                bounds.velocity.divergence,
                                timer.wall_time()};
          if (writes_fields())
            output.write(
              {body, bounds.stress, bounds.velocity.velocity, bounds.gaps},
              cycle);
        }
    });
    row = Utilities::MPI::broadcast(communicator, row);
    table.add_row(row);
    error_indicators = cell_indicators(body.mesh, bounds.gaps, triangulation);

    std::ostringstream message;
    message.precision(8);
    message << "Cycle " << cycle << ": " << row[2]
            << " triangles, limit load between " << row[3] << " and " << row[4]
            << " (" << 100. * row[5] << " %), " << row[10] << " s";
    screen.remark(message.str());
  }



  bool
  LimitLoadAnalysis::is_last_cycle() const
  {
    return cycle + 1 >= parameters.refinement.n_cycles;
  }



  bool
  LimitLoadAnalysis::writes_fields() const
  {
    return parameters.output.fields == "every cycle" ||
           (parameters.output.fields == "last cycle" && is_last_cycle());
  }



  bool
  LimitLoadAnalysis::mark_next_mesh()
  {
    if (is_last_cycle())
      return false;
    flag_cells(parameters.refinement, error_indicators, triangulation);
    return true;
  }
} // namespace ElastoPlastic
