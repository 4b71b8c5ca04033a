// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_run_error_estimate_h
#define contact_run_error_estimate_h

#include <memory>
#include <string>

#include "adaptivity/kelly_estimator.h"
#include "contact_run/guaranteed_error.h"

namespace ElastoPlastic
{
  /// How large the error of a solution is, and in which cells: by the estimator
  /// of Kelly, or, with `Analysis = contact with error bound`, by a bound that
  /// is guaranteed.
  template <int dim>
  class ErrorEstimate
  {
  public:
    /// All arguments but the last must outlive this object. @throws InputError
    /// if a bound is asked for and cannot be made.
    ErrorEstimate(const Parameters               &parameters,
                  DiscreteBody<dim>              &body,
                  Log                            &log,
                  TimerOutput                    &timer,
                  const MakeGuaranteedError<dim> &make_error_bound);

    /// Finds the estimated error of @p result, a solution under @p load, and
    /// the indicators of the body. For @p displacement_at see
    /// GuaranteedError. Collective.
    void
    evaluate(
      SolveResult                                         &result,
      const Load                                          &load,
      const typename GuaranteedError<dim>::DisplacementAt &displacement_at);

    /// Finds the indicators of the body, by KellyEstimator. Collective.
    void
    find_indicators();

    /// Why there is no bound of the last solution; empty if there is, or if
    /// none is asked for.
    std::string
    why_bound_is_missing() const
    {
      return error_bound ? error_bound->why_missing() : "";
    }

    /// Writes the fields of the equilibrium method, if there are any, with the
    /// number of the mesh. @throws FileError
    void
    write_fields(const unsigned int cycle);

  private:
    void
    bound(SolveResult                                         &result,
          const Load                                          &load,
          const typename GuaranteedError<dim>::DisplacementAt &displacement_at);

    const Parameters         &parameters;
    DiscreteBody<dim>        &body;
    Log                      &log;
    TimerOutput              &timer;
    const KellyEstimator<dim> kelly_estimator;
    /// None if it is not asked for.
    std::unique_ptr<GuaranteedError<dim>> error_bound;
  };
} // namespace ElastoPlastic

#endif
