// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "adaptivity/refinement.h"
#include "base/exceptions.h"
#include "base/process.h"
#include "base/text.h"
#include "bounds/body/loads.h"
#include "bounds/conic/tolerances.h"
#include "bounds/limit_load_analysis.h"
#include "bounds/mesh/predicted_gaps.h"
#include "bounds/stress/stress_check.h"
#include "mesh/material_ids.h"
#include "output/columns.h"
#include "restart/output_directory.h"

namespace ElastoPlastic
{
  namespace
  {
    void
    warn_if_any(Log &log, const std::string &warning)
    {
      if (!warning.empty())
        log.warn(warning);
    }



    template <int dim>
    unsigned int
    degree_of_stresses(const SplitBody<dim> &body, const Parameters &parameters)
    {
      return dim == 3 ?
               1 :
               parameters.limit_load.degree_of_stresses(body.is_axisymmetric());
    }



    /// All materials must be perfectly plastic. @throws InputError
    void
    check_materials_of_limit_load(
      const std::vector<Material<double>> &materials)
    {
      for (const Material<double> &material : materials)
        if (!std::isfinite(material.yield_radius) || !is_perfect(material))
          throw InputError(
            "Analysis",
            "limit load",
            "only a body of perfectly plastic materials has a limit load that "
            "this analysis can find. Set 'Material/Law = perfectly plastic' "
            "with a yield stress for each material, and 'Rate law = none'.");
    }



    /// Whether the loads that do not grow are too much for the body, if the
    /// load factor is between these bounds; empty if not.
    std::string
    warning_of_constant_loads(const double lower_bound,
                              const double upper_bound)
    {
      if (lower_bound >= 0.)
        return "";
      return std::string(
               upper_bound < 0. ?
                 "The load factor is negative: the body" :
                 "The load factor may be negative: perhaps the body") +
             " does not bear the tractions and body forces that are constant, "
             "unless the others act against the direction in which they are "
             "given. Look at the signs, or prescribe smaller constant loads.";
    }



    /// What the bounds are those of: a force of the indenter, or, if the other
    /// loads grow, a factor of these.
    std::string
    name_of_bounded(const bool loads_grow)
    {
      return loads_grow ? "load factor of the limit load" : "limit load";
    }



    /// What limit_load.pvd shows of two @p bounds, which must live as long as
    /// the result.
    template <int dim>
    EquilibriumFields<dim>
    fields_of(const SplitBody<dim> &body, const LimitLoad<dim> &bounds)
    {
      std::vector<double> work = bounds.velocity.dissipation;
      for (unsigned int t = 0; t < work.size(); ++t)
        work[t] /= bounds.body_of_velocity.volume(t);
      return {body,
              bounds.stress,
              [&bounds](const unsigned int t, const Barycentric<dim> &point) {
                return velocity_at(bounds.body_of_velocity,
                                   bounds.velocity.velocity[t],
                                   t,
                                   point);
              },
              bounds.gaps,
              work};
    }



    /// How close bounds come to the best ones of their mesh. In space, they
    /// need not be much closer than the mesh allows, for which the last one
    /// gives an example.
    template <int dim>
    double
    tolerance_after(const double last_difference)
    {
      return dim == 2 ?
               Tolerance::gap_of_bounds<dim> :
               std::clamp(Tolerance::part_of_difference * last_difference,
                          Tolerance::gap_of_bounds<dim>,
                          Tolerance::largest_gap_in_space);
    }
  } // namespace



  template <int dim>
  LimitLoadAnalysis<dim>::LimitLoadAnalysis(const Model<dim> &model,
                                            const Parameters &parameters,
                                            const MPI_Comm    communicator)
    : model(model)
    , parameters(parameters)
    , communicator(communicator)
    , first_rank(Utilities::MPI::this_mpi_process(communicator) == 0)
    , log(communicator, parameters.output.screen)
    , output(parameters.output, "limit_load", "velocity")
    , slip_output(parameters.output)
    , triangulation(communicator)
    , gap_function(make_mesh_and_place_indenter(model, triangulation))
  {
    if (parameters.limit_load.load == GrowingLoad::tractions)
      loads = [&model](const auto &mesh) {
        return Loads<dim>::growing(mesh,
                                   model.boundary_conditions,
                                   model.body_force);
      };
    else
      loads = [&model](const auto &) {
        return Loads<dim>(/* time = */ 0., model.body_force);
      };
    check_materials_of_limit_load(model.materials);
    check_material_ids(triangulation, model.materials.size());
    for (const std::string &warning : model.geometry.warnings())
      log.warn(warning);
    warn_if_any(log,
                warning_of_unused_materials(triangulation,
                                            model.materials.size()));
  }



  template <int dim>
  void
  LimitLoadAnalysis<dim>::run(const bool overwrite)
  {
    log.print_banner(Utilities::MPI::n_mpi_processes(communicator));
    check();
    note_termination_requests();
    OutputDirectory directory(communicator, parameters.output.directory);
    directory.begin_run(overwrite, parameters.effective_input);
    write_table_reference(communicator, parameters.output);
    CsvTable<LimitLoadRow> table(communicator,
                                 parameters.output.directory +
                                   "/limit_load.csv",
                                 limit_load_columns());
    table.open();
    while (true)
      {
        find_bounds_or_say_last();
        warn_of_rounding_errors();
        write_results(table);
        directory.accept_results();
        if (is_last_cycle())
          break;
        refine_mesh();
      }
    warn_if_any(log,
                warning_of_constant_loads(row.lower_bound, row.upper_bound));
    log.remark("Results are in " + parameters.output.directory);
  }



  // The work of the first rank, while the others wait for its results.
  template <int dim>
  void
  LimitLoadAnalysis<dim>::find_bounds()
  {
    const Timer timer;
    rethrow_collectively(communicator, [&]() {
      if (!first_rank)
        return;
      bounds                    = bound_limit_load(body,
                                degree_of_stresses(body, parameters),
                                tolerance_after<dim>(last_difference()),
                                expected);
      const double stress_error = require_admissible(body, bounds.stress);
      row                       = {cycle,
                                   static_cast<unsigned int>(body.mesh.cells.size()),
                                   static_cast<unsigned int>(body.mesh.simplices.size()),
                                   bounds.lower_bound,
                                   bounds.upper_bound,
                                   bounds.stress.n_iterations,
                                   bounds.velocity.n_iterations,
                                   stress_error,
                                   bounds.velocity.error,
                                   timer.wall_time()};
    });
    row = Utilities::MPI::broadcast(communicator, row);

    const std::string  simplices = dim == 2 ? "triangles" : "tetrahedra";
    std::ostringstream message;
    message.precision(8);
    message << row.triangles << ' ' << simplices << ": the "
            << name_of_bounded(body.load_factor_unit > 0) << " is between "
            << row.lower_bound << " and " << row.upper_bound;
    if (row.lower_bound != 0.)
      message << " (" << 100. * row.relative_difference() << " %)";
    message << ", " << row.wall_seconds << " s";
    log.remark(message.str());
    log.table_row("cycle cells " + simplices + " lower_bound upper_bound",
                  std::to_string(row.cycle) + ' ' + std::to_string(row.cells) +
                    ' ' + std::to_string(row.triangles) + ' ' +
                    to_text(row.lower_bound) + ' ' + to_text(row.upper_bound));
  }



  template <int dim>
  void
  LimitLoadAnalysis<dim>::warn_of_rounding_errors()
  {
    if (first_rank && !(bounds.stress.is_optimal && bounds.velocity.is_optimal))
      log.warn(
        "Rounding errors have ended the interior point method early. "
        "The bounds hold, but this mesh has closer ones.");
  }



  // The row is that of the mesh before until there is another one.
  template <int dim>
  void
  LimitLoadAnalysis<dim>::find_bounds_or_say_last()
  {
    try
      {
        if (termination_requested(communicator))
          throw TerminationError("Ended on request (SIGTERM).");
        find_bounds();
      }
    catch (const Error &error)
      {
        if (cycle == 0)
          throw;
        throw_error(error.status,
                    std::string(error.what()) + " The " +
                      name_of_bounded(parameters.limit_load.load ==
                                      GrowingLoad::tractions) +
                      " is between " + to_text(row.lower_bound) + " and " +
                      to_text(row.upper_bound) +
                      ", as the mesh before has shown.");
      }
  }



  template <int dim>
  void
  LimitLoadAnalysis<dim>::write_results(CsvTable<LimitLoadRow> &table)
  {
    table.add(row);
    if (parameters.output.fields == FieldOutputTimes::every_cycle ||
        (parameters.output.fields == FieldOutputTimes::last_cycle &&
         is_last_cycle()))
      rethrow_collectively(communicator, [&]() {
        if (!first_rank)
          return;
        output.write(fields_of(body, bounds), cycle);
        slip_output.write(bounds.body_of_velocity,
                          bounds.velocity.velocity,
                          cycle);
      });
  }



  // Each pass refines its part of the cells that are to be refined. Cells are
  // put together in the last one: no prediction for them is needed then.
  template <int dim>
  void
  LimitLoadAnalysis<dim>::refine_mesh()
  {
    const PredictedGaps<dim> gaps(body.mesh, bounds.gaps, communicator);
    const double             n_cells_before = n_cells();
    const unsigned int       n_passes =
      parameters.refinement.is_adaptive() ? parameters.refinement.n_passes : 1;
    for (unsigned int i = 1; i <= n_passes; ++i)
      {
        RefinementParameters pass = parameters.refinement;
        pass.refinement_fraction *= n_cells_before / (n_passes * n_cells());
        if (i < n_passes)
          pass.coarsening_fraction = 0.;
        flag_cells(pass,
                   gaps.indicators(triangulation),
                   gaps.accuracy,
                   triangulation);
        triangulation.execute_coarsening_and_refinement();
      }
    check_material_ids(triangulation, model.materials.size());
    const SplitMesh<dim> last = std::move(body.mesh);
    setup_body();
    rethrow_collectively(communicator, [&]() {
      if (first_rank)
        expected = expected_multipliers(bounds, last, body.mesh);
    });
    ++cycle;
  }
} // namespace ElastoPlastic

// The rest of the class, which is compiled and instantiated as a whole:
#include "limit_load_analysis_checks.cc"
#include "limit_load_analysis_safety.cc"

namespace ElastoPlastic
{
  template class LimitLoadAnalysis<2>;
  template class LimitLoadAnalysis<3>;
} // namespace ElastoPlastic
