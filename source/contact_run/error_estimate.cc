// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "base/compatibility.h"
#include "contact_run/error_estimate.h"

namespace ElastoPlastic
{
  template <int dim>
  ErrorEstimate<dim>::ErrorEstimate(
    const Parameters               &parameters,
    DiscreteBody<dim>              &body,
    Log                            &log,
    TimerOutput                    &timer,
    const MakeGuaranteedError<dim> &make_error_bound)
    : parameters(parameters)
    , body(body)
    , log(log)
    , timer(timer)
    , kelly_estimator(body.fe)
  {
    if (parameters.analysis == Analysis::contact_with_error_bound)
      error_bound = make_error_bound(body, parameters, log);
  }



  template <int dim>
  void
  ErrorEstimate<dim>::evaluate(
    SolveResult                                         &result,
    const Load                                          &load,
    const typename GuaranteedError<dim>::DisplacementAt &displacement_at)
  {
    find_indicators();
    result.estimated_error =
      std::sqrt(Utilities::MPI::sum(body.error_indicators().norm_sqr(),
                                    communicator_of(body.triangulation())));
    if (error_bound)
      bound(result, load, displacement_at);
  }



  template <int dim>
  void
  ErrorEstimate<dim>::find_indicators()
  {
    TimerOutput::Scope scope(timer, "Error estimator");
    body.set_error_indicators(
      kelly_estimator.estimate(body.dof_handler(), body.displacement()));
  }



  // The bound is a number that one can rely on. Cell by cell, it also tells
  // where to refine, unless the user prefers Kelly.
  template <int dim>
  void
  ErrorEstimate<dim>::bound(
    SolveResult                                         &result,
    const Load                                          &load,
    const typename GuaranteedError<dim>::DisplacementAt &displacement_at)
  {
    TimerOutput::Scope scope(timer, "Error bound");
    result.estimated_error = error_bound->evaluate({body.dof_handler(),
                                                    body.displacement(),
                                                    load,
                                                    result.depth,
                                                    result.force,
                                                    result.time,
                                                    result.cycle},
                                                   displacement_at);
    if (!error_bound->why_missing().empty())
      return;
    if (parameters.refinement.strategy != RefinementStrategy::kelly)
      body.set_error_indicators(error_bound->indicators());
    const auto &indenter = body.model.indenter.shape;
    log.remark("The error of the stresses in equilibrium is at most " +
               Patterns::Tools::to_string(result.estimated_error) +
               (!indenter || indenter->is_convex() ?
                  "" :
                  ", provided that the sides of the mesh resolve the indenter, "
                  "which is not known to be convex"));
  }



  template <int dim>
  void
  ErrorEstimate<dim>::write_fields(const unsigned int cycle)
  {
    if (error_bound && error_bound->why_missing().empty())
      error_bound->write_fields(cycle);
  }



  template class ErrorEstimate<2>;
  template class ErrorEstimate<3>;
} // namespace ElastoPlastic
