// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>
#include <string>
#include <vector>

#include "base/exceptions.h"
#include "contact_run/unloading_stiffness.h"
#include "multigrid/make_tangent_solver.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The linear system is solved so well that its error is below that of the
    /// tangents, which are stored in single precision.
    constexpr double residual_reduction = 1e-8;



    /// The same materials without yield surfaces. (As many back stresses, so
    /// that states of the points fit.)
    std::vector<Material<double>>
    without_yielding(std::vector<Material<double>> materials)
    {
      for (Material<double> &material : materials)
        {
          material.yield_radius      = std::numeric_limits<double>::infinity();
          material.isotropic_modulus = 0.;
          material.curves            = {};
          material.rate_laws         = {};
          material.is_linear         = true;
          for (auto &law : material.back_stresses)
            law.recovery = 0.;
        }
      return materials;
    }



    /// Lets what slips along the indenter stick to it: a bound that no other
    /// unknown moves. @return these others.
    std::vector<unsigned int>
    hold(std::vector<SlopedBound> &bounds)
    {
      std::vector<unsigned int> held;
      for (SlopedBound &bound : bounds)
        {
          held.insert(held.end(),
                      bound.others.begin(),
                      bound.others.begin() + bound.n_others);
          bound.slope = bound.force_slope = {{0., 0.}};
          bound.curvature                 = {};
        }
      return held;
    }
  } // namespace



  template <int dim>
  UnloadingStiffness<dim>::UnloadingStiffness(
    const DiscreteBody<dim>      &body,
    const LinearSolverParameters &linear_solver,
    Log                          &log,
    TimerOutput                  &timer)
    : body(body)
    , linear_solver(linear_solver)
    , log(log)
    , timer(timer)
    , mesh_changes(body.triangulation().signals.any_change.connect([this]() {
      tangent_solver.reset();
      elastic_solid.reset();
    }))
  {}



  template <int dim>
  double
  UnloadingStiffness<dim>::compute()
  {
    if (body.contact().n_closed() == 0)
      return std::numeric_limits<double>::quiet_NaN();
    TimerOutput::Scope scope(timer, "Continuous stiffness");
    if (!elastic_solid)
      take_mesh();
    elastic_solid->set_states(body.solid().states());
    elastic_solid->linearize(body.displacement());
    try
      {
        return solve(unknowns_of_contact());
      }
    catch (const ConvergenceError &error)
      {
        log.warn(
          "'Evaluation/Continuous stiffness' is missing for this step. " +
          std::string(error.what()));
        return std::numeric_limits<double>::quiet_NaN();
      }
  }



  template <int dim>
  void
  UnloadingStiffness<dim>::take_mesh()
  {
    elastic_solid =
      std::make_unique<SolidOperator<dim>>(body.model.degree,
                                           body.model.strain_model,
                                           without_yielding(
                                             body.model.materials));
    if (body.solid().keeps_increments())
      elastic_solid->keep_increments();
    elastic_solid->reinit(body.dof_handler(), body.supports().constraints());
    tangent_solver =
      make_tangent_solver(linear_solver,
                          body.model,
                          *elastic_solid,
                          body.dof_handler(),
                          body.supports().constraints(),
                          [this](const std::string &warning) {
                            log.warn("'Evaluation/Continuous stiffness': " +
                                     warning);
                          });
  }



  // As in a step with a given force: the depth follows.
  template <int dim>
  ReducedUnknowns
  UnloadingStiffness<dim>::unknowns_of_contact() const
  {
    std::vector<unsigned int> constrained =
      body.supports().fixed_entries(body.external_forces());
    auto bounds =
      body.contact().sloped_bounds(body.displacement(), body.residual());
    if (body.contact().has_friction())
      {
        const auto held = hold(bounds);
        constrained.insert(constrained.end(), held.begin(), held.end());
      }
    ReducedUnknowns unknowns(constrained,
                             body.contact().closed_entries(),
                             body.external_forces().get_mpi_communicator(),
                             body.contact().shared_forces(body.displacement(),
                                                          body.residual()));
    if (body.contact().has_sloped_bounds())
      unknowns.set_sloped_bounds(bounds);
    return unknowns;
  }



  template <int dim>
  double
  UnloadingStiffness<dim>::solve(const ReducedUnknowns &unknowns)
  {
    VectorType unit_force, motion;
    elastic_solid->initialize_vector(unit_force);
    elastic_solid->initialize_vector(motion);
    unknowns.set_leading_value(unit_force, 1.);
    tangent_solver->prepare(unknowns);
    tangent_solver->solve(motion, unit_force, residual_reduction);
    return 1. / unknowns.leading_value(motion);
  }



  template class UnloadingStiffness<2>;
  template class UnloadingStiffness<3>;
} // namespace ElastoPlastic
