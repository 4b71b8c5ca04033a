// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <numeric>
#include <string>

#include "base/exceptions.h"
#include "base/text.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/velocity_check.h"
#include "bounds/mechanism/velocity_program.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    VelocityField<dim>
    find_mechanism(const SplitBody<dim>      &body,
                   const double               tolerance,
                   const std::vector<double> &expected)
    {
      if (!body.can_slide())
        return find_continuous_motion(body, tolerance, expected);
      if constexpr (dim == 2)
        return find_stream(body, tolerance, expected);
      else
        return find_flux(body, tolerance, expected);
    }



    /// Scales the velocities of a @p field, which is up to a factor, so that
    /// the indenter moves down by 1, or if it is other loads that grow, the
    /// largest velocity is 1; and replaces the bound that has been minimised by
    /// that which follows from the velocities alone.
    /// @throws ConvergenceError if they are no admissible mechanism.
    template <int dim>
    void
    evaluate_mechanism(const SplitBody<dim> &body, VelocityField<dim> &field)
    {
      const bool   loads_grow = body.load_factor_unit > 0;
      const double minimum    = field.bound;
      const double size = loads_grow ? largest_velocity(body, field.velocity) :
                                       lowest_depth(body, field.velocity);
      if (!(size > 0. && std::isfinite(size)))
        throw ConvergenceError(
          "No mechanism of collapse has been found, because of rounding "
          "errors.");
      for (SimplexVelocity<dim> &velocity : field.velocity)
        velocity *= 1. / size;

      field.error = check_velocity(body, field.velocity).largest();
      if (!(field.error <= Tolerance::admissibility))
        throw ConvergenceError(
          "The mechanism of collapse violates its conditions by " +
          to_text(field.error) +
          " of its velocity, because of rounding errors.");

      const TwoLoads power = power_of_loads(body, field.velocity);
      if (loads_grow && !(power.growing > 0))
        throw ConvergenceError(
          "The loads that grow have no power in the mechanism of collapse, "
          "because of rounding errors.");
      field.dissipation = plastic_work(body, field.velocity);
      field.bound       = std::accumulate(field.dissipation.begin(),
                                    field.dissipation.end(),
                                    -power.constant) /
                    (loads_grow ? power.growing : 1.);
      if (!(field.bound - minimum <=
            Tolerance::loss_of_minimum * std::abs(minimum)))
        field.is_optimal = false;
    }
  } // namespace



  template <int dim>
  VelocityField<dim>
  minimize_plastic_work(const SplitBody<dim>      &body,
                        const double               tolerance,
                        const std::vector<double> &expected_multipliers)
  {
    try
      {
        VelocityField<dim> field =
          find_mechanism(body, tolerance, expected_multipliers);
        evaluate_mechanism(body, field);
        return field;
      }
    catch (const UnboundedError &)
      {
        throw ConvergenceError(
          std::string(
            body.load_factor_unit > 0 ?
              "No velocity lets the loads that grow do work: the supports "
              "enclose the body." :
              "No velocity moves the whole indenter down: it reaches a point "
              "that is held, or the supports enclose the body. Let "
              "'Indenter/Reach' end before what is held.") +
          (dim == 2 && body.can_slide() ?
             " (Mechanisms that change the volume of a hole are not "
             "looked for.)" :
             ""));
      }
  }



  template VelocityField<2>
  minimize_plastic_work(const SplitBody<2> &,
                        const double,
                        const std::vector<double> &);
  template VelocityField<3>
  minimize_plastic_work(const SplitBody<3> &,
                        const double,
                        const std::vector<double> &);
} // namespace ElastoPlastic
