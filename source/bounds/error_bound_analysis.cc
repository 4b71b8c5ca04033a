// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "bounds/error/support_check.h"
#include "bounds/error_bound_analysis.h"
#include "bounds/mesh/predicted_gaps.h"
#include "bounds/stress/stress_check.h"
#include "bounds/stress/stress_field.h"

namespace ElastoPlastic
{
  namespace
  {
    void
    check_is_linear(const std::vector<Material<double>> &materials)
    {
      for (const Material<double> &material : materials)
        {
          if (material.curves[0] || has_recovery(material) ||
              is_rate_dependent(material))
            throw InputError(
              "Analysis",
              "contact with error bound",
              "the equilibrium method knows linear hardening only. Choose a "
              "'Material/Law' without hardening curve and recovery, and 'Rate "
              "law = none'.");
          if (has_general_criterion(material) &&
              !material.back_stresses.empty())
            throw InputError(
              "Analysis",
              "contact with error bound",
              "with 'Material/Yield criterion = Hill', the equilibrium method "
              "knows isotropic hardening only, or none. Choose 'Material/Law "
              "= isotropic hardening' or 'perfectly plastic'.");
        }
    }



    constexpr unsigned int degree_of_stresses = 1;



    template <int dim>
    SplitBody<dim>
    make_body(SplitMesh<dim>          mesh,
              const Model<dim>       &model,
              const GapFunction<dim> &gap_function,
              const double            time)
    {
      SplitBody<dim> body =
        make_split_body<dim>(std::move(mesh),
                             model.boundary_conditions,
                             model.materials,
                             {[&gap_function](const Point<dim> &x) {
                                return gap_function.value(x);
                              },
                              SurfaceFinish::smooth,
                              ContactGeometry::vertical,
                              gap_function.footprint()},
                             time,
                             model.strain_model.kinematics);
      if constexpr (dim == 2) // (in space, make_split_body() looks at loads)
        {
          require_quadratic_supports(body);
          require_polynomial_tractions(body, degree_of_stresses);
        }
      body.set_initial_stress(model.initial_stress);
      return body;
    }

  } // namespace



  template <int dim>
  ErrorBoundAnalysis<dim>::ErrorBoundAnalysis(
    const Model<dim>         &model,
    const Parameters         &parameters,
    const MPI_Comm            communicator,
    const GapFunction<dim>   &gap_function,
    const Triangulation<dim> &triangulation)
    : model(model)
    , parameters(parameters)
    , communicator(communicator)
    , gap_function(gap_function)
    , output(parameters.output, "equilibrium", "displacement")
  {
    check_is_linear(model.materials);
    auto mesh = make_split_mesh(triangulation);
    rethrow_collectively(communicator, [&]() {
      if (!mesh.simplices.empty())
        make_body(std::move(mesh),
                  model,
                  gap_function,
                  model.load_program.final_time());
    });
  }



  template <int dim>
  StressField<dim>
  ErrorBoundAnalysis<dim>::equilibrate(const Load &load) const
  {
    if (!gap_function.has_indenter())
      return equilibrate_with_depth(body, 0.);
    return load.control == Control::force ?
             equilibrate_with_force(body, load.value) :
             equilibrate_with_depth(body, load.value);
  }



  // Close to the limit load, a coarse mesh may have no stresses in equilibrium
  // with the force that satisfy the yield condition; the next mesh may.
  template <int dim>
  double
  ErrorBoundAnalysis<dim>::evaluate(const Solution       &solution,
                                    const DisplacementAt &displacement_at)
  {
    reason_why_missing.clear();
    try
      {
        const Timer   timer;
        ErrorBoundRow row = find_bound(solution);
        bound_load(row, solution, displacement_at);
        row.wall_seconds = timer.wall_time();
        if (!table)
          {
            table.emplace(communicator,
                          parameters.output.directory + "/error_bound.csv",
                          error_bound_columns());
            table->open();
          }
        table->add(row);
        error_indicators =
          PredictedGaps<dim>(body.mesh, errors, communicator)
            .indicators(solution.dof_handler.get_triangulation());
        error_indicators *= std::sqrt(2.);
        return std::sqrt(2. * std::max(0., row.bound()));
      }
    catch (const ConvergenceError &error)
      {
        reason_why_missing = error.what();
        return std::numeric_limits<double>::infinity();
      }
  }



  // The work of the first rank, while the others wait for its results. Energy
  // and complementary energy are those under the prescribed load: under a
  // prescribed force, the indenter takes part in the former, -F V; under a
  // prescribed depth in the latter, -F V as well.
  template <int dim>
  ErrorBoundRow
  ErrorBoundAnalysis<dim>::find_bound(const Solution &solution)
  {
    auto       mesh = make_split_mesh(solution.dof_handler.get_triangulation());
    const bool has_mesh = !mesh.simplices.empty();
    displacement =
      QuadraticField<dim>::interpolate_displacement(mesh,
                                                    solution.dof_handler,
                                                    solution.displacement);

    ErrorBoundRow row = {};
    rethrow_collectively(communicator, [&]() {
      if (!has_mesh)
        return;
      body   = make_body(std::move(mesh), model, gap_function, solution.time);
      stress = equilibrate(solution.load);
      const double stress_error = require_admissible(body, stress);
      remove_penetration(displacement, body, solution.depth);
      const ErrorBound bound =
        bound_error(body, displacement, solution.depth, stress);
      if (solution.force > 0. && stress.force == 0.)
        throw ConvergenceError(
          "No side or face of the mesh lies within the reach of the indenter "
          "as a whole, so that the stresses in equilibrium bear nothing of its "
          "force. Refine the mesh under it, or let 'Indenter/Reach' end at a "
          "node, or farther away.");
      if (!std::isfinite(bound.total()))
        throw ConvergenceError("The energies on this mesh are not finite.");
      errors = bound.indicators(body.mesh);
      row    = {solution.cycle,
                static_cast<unsigned int>(body.mesh.cells.size()),
                solution.dof_handler.n_dofs(),
                static_cast<unsigned int>(body.mesh.simplices.size()),
                solution.depth,
                solution.force,
                stress.depth,
                stress.force,
                stress.max_pressure(),
                stress.contact_area(body),
                stress.cost,
                bound.of_body(),
                bound.of_contact(),
                stress.n_iterations,
                stress_error,
                /* wall_seconds = */ 0.,
                {},
                {}};
    });
    return Utilities::MPI::broadcast(communicator, row);
  }



  // The bounds are the farther apart the shorter the step, because of the gap
  // between the energies, and the longer the step, because of their curvature:
  // alike for these steps, if the force grows like the depth.
  template <int dim>
  void
  ErrorBoundAnalysis<dim>::bound_load(ErrorBoundRow        &row,
                                      const Solution       &solution,
                                      const DisplacementAt &displacement_at)
  {
    const double force = row.equilibrium_force, depth = solution.depth;
    row.force_bounds = {force, force};
    row.depth_bounds = {depth, depth};
    if (!gap_function.has_indenter())
      return;

    constexpr double infinity    = std::numeric_limits<double>::infinity();
    const bool       is_by_force = solution.load.control == Control::force;
    auto            &bounds = is_by_force ? row.depth_bounds : row.force_bounds;
    bounds                  = {-infinity, infinity};
    const double energy =
      std::abs((is_by_force ? force * depth : 0.) - row.complementary_energy);
    if (force == 0. || energy == 0. || row.bound() <= 0.)
      return;

    errors_of_load.assign(errors.size(), 0.);
    if (is_by_force)
      {
        const double step =
          force * std::min(std::sqrt(row.bound() / energy), 0.5);
        bounds = {depth - energy_gap_under_force(force - step, solution) / step,
                  depth +
                    energy_gap_under_force(force + step, solution) / step};
      }
    else
      {
        const double step = 2. * std::sqrt(row.bound() * energy) / force;
        bounds            = {
                     force -
                       energy_gap_at_depth(depth - step, solution, displacement_at) / step,
                     force + energy_gap_at_depth(depth + step, solution, displacement_at) /
                               step};
      }
    if (parameters.refinement.goal == RefinementGoal::force &&
        std::isfinite(bounds.upper - bounds.lower))
      errors = errors_of_load;
  }



  template <int dim>
  double
  ErrorBoundAnalysis<dim>::energy_gap_at_depth(
    const double          depth,
    const Solution       &solution,
    const DisplacementAt &displacement_at)
  {
    try
      {
        QuadraticField<dim> field =
          QuadraticField<dim>::interpolate_displacement(body.mesh,
                                                        solution.dof_handler,
                                                        displacement_at(depth));
        return on_first_rank([&]() {
          remove_penetration(field, body, depth);
          return energy_gap(field, depth, stress);
        });
      }
    catch (const ConvergenceError &)
      {
        return std::numeric_limits<double>::infinity();
      }
  }



  template <int dim>
  double
  ErrorBoundAnalysis<dim>::energy_gap_under_force(const double    force,
                                                  const Solution &solution)
  {
    try
      {
        return on_first_rank([&]() {
          const StressField<dim> other = equilibrate_with_force(body, force);
          require_admissible(body, other);
          return energy_gap(displacement, solution.depth, other);
        });
      }
    catch (const ConvergenceError &)
      {
        return std::numeric_limits<double>::infinity();
      }
  }



  template <int dim>
  double
  ErrorBoundAnalysis<dim>::energy_gap(const QuadraticField<dim> &displacement,
                                      const double               depth,
                                      const StressField<dim>    &stress)
  {
    const ErrorBound bound = bound_error(body, displacement, depth, stress);
    const std::vector<double> parts = bound.indicators(body.mesh);
    for (unsigned int t = 0; t < parts.size(); ++t)
      errors_of_load[t] += parts[t];
    return bound.total();
  }



  template <int dim>
  double
  ErrorBoundAnalysis<dim>::on_first_rank(
    const std::function<double()> &function) const
  {
    double result = 0;
    rethrow_collectively(communicator, [&]() {
      if (!body.mesh.simplices.empty())
        result = function();
    });
    return Utilities::MPI::broadcast(communicator, result);
  }



  template <int dim>
  void
  ErrorBoundAnalysis<dim>::write_fields(const unsigned int cycle)
  {
    rethrow_collectively(communicator, [&]() {
      if (body.mesh.simplices.empty())
        return;
      output.write(
        EquilibriumFields<dim>{
          body,
          stress,
          [this](const unsigned int t, const Barycentric<dim> &point) {
            return displacement.value(body.mesh.simplices[t], point);
          },
          errors},
        cycle);
    });
  }



  template class ErrorBoundAnalysis<2>;
  template class ErrorBoundAnalysis<3>;
} // namespace ElastoPlastic
