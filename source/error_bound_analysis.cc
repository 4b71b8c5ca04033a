// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <cmath>

#include "base/exceptions.h"
#include "base/rethrow_collectively.h"
#include "equilibrium/cell_indicators.h"
#include "equilibrium/stress_check.h"
#include "equilibrium/stress_problem.h"
#include "error_bound_analysis.h"

namespace ElastoPlastic
{
  namespace
  {
    const std::vector<std::string> error_bound_columns = {
      "cycle",
      "cells",
      "dofs",
      "triangles",
      "depth",
      "force",
      "equilibrium_depth",
      "equilibrium_force",
      "equilibrium_max_pressure",
      "equilibrium_contact_area",
      "energy",
      "complementary_energy",
      "bound_of_body",
      "bound_of_contact",
      "bound",
      "relative_bound",
      "iterations",
      "stress_error",
      "wall_seconds"};



    void
    check_is_linear(const std::vector<Material<double>> &materials)
    {
      for (const Material<double> &material : materials)
        if (!material.is_linear)
          throw InputError(
            "Analysis",
            "contact with error bound",
            "the equilibrium method knows linear hardening only. Choose a "
            "'Material/Law' without hardening curve and recovery.");
    }
  } // namespace



  ErrorBoundAnalysis::ErrorBoundAnalysis(const Model<2>       &model,
                                         const Parameters     &parameters,
                                         const MPI_Comm        communicator,
                                         const GapFunction<2> &gap_function)
    : model(model)
    , parameters(parameters)
    , communicator(communicator)
    , gap_function(gap_function)
    , output(parameters.output.directory, "equilibrium", "displacement")
  {
    check_is_linear(model.materials);
  }



  StressField
  ErrorBoundAnalysis::equilibrate(const PlaneBody &body, const Load &load) const
  {
    if (!gap_function.has_indenter())
      return equilibrate_with_depth(body, 0.);
    return load.control == Control::force ?
             equilibrate_with_force(body, load.value) :
             equilibrate_with_depth(body, load.value);
  }



  // The work of the first rank, while the others wait for its results. Energy
  // and complementary energy are those under the prescribed load: under a
  // prescribed force, the indenter takes part in the former, -F V; under a
  // prescribed depth in the latter, -F V as well.
  ErrorBoundAnalysis::Result
  ErrorBoundAnalysis::evaluate(const Solution &solution)
  {
    const Timer             timer;
    const Triangulation<2> &triangulation =
      solution.dof_handler.get_triangulation();
    const auto gap = [this](const Point<2> &x) {
      return gap_function.value(x);
    };
    SplitMesh  mesh     = make_split_mesh(triangulation);
    const bool has_mesh = !mesh.triangles.empty();
    displacement        = interpolate_displacement(mesh,
                                            solution.dof_handler,
                                            solution.displacement);

    std::vector<double> row(error_bound_columns.size());
    double              total = 0;
    rethrow_collectively(communicator, [&]() {
      if (!has_mesh)
        return;
      body               = make_plane_body(std::move(mesh),
                             model.boundary_conditions,
                             model.materials,
                             model.strain_model.kinematics,
                             gap,
                             solution.time);
      stress             = equilibrate(body, solution.load);
      const double error = require_admissible(body, stress);
      remove_penetration(displacement, body, solution.depth);
      const ErrorBound bound =
        bound_error(body, displacement, solution.depth, stress);
      errors = bound.indicators(body.mesh);
      total  = bound.total();
      row    = {static_cast<double>(solution.cycle),
                static_cast<double>(body.mesh.cells.size()),
                static_cast<double>(solution.dof_handler.n_dofs()),
                static_cast<double>(body.mesh.triangles.size()),
                solution.depth,
                solution.force,
                stress.depth,
                stress.force,
                stress.max_pressure(),
                stress.contact_area(body.mesh),
                bound.total() - stress.cost,
                stress.cost,
                bound.of_body(),
                bound.of_contact(),
                bound.total(),
                bound.total() / std::abs(stress.cost),
                static_cast<double>(stress.n_iterations),
                error,
                timer.wall_time()};
    });

    row   = Utilities::MPI::broadcast(communicator, row);
    total = Utilities::MPI::broadcast(communicator, total);
    if (!table)
      {
        table.emplace(communicator,
                      parameters.output.directory + "/error_bound.csv",
                      error_bound_columns);
        table->open();
      }
    table->add_row(row);

    Result result = {std::sqrt(2. * std::max(0., total)),
                     cell_indicators(body.mesh, errors, triangulation)};
    result.of_cells *= std::sqrt(2.);
    return result;
  }



  void
  ErrorBoundAnalysis::write_fields(const unsigned int cycle)
  {
    rethrow_collectively(communicator, [&]() {
      if (!body.mesh.triangles.empty())
        output.write({body, stress, displacement, errors}, cycle);
    });
  }
} // namespace ElastoPlastic
