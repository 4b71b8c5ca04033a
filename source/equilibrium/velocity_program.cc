// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <cmath>
#include <numeric>

#include "equilibrium/certificate.h"
#include "equilibrium/sheet_program.h"
#include "equilibrium/stream_program.h"
#include "equilibrium/velocity_check.h"
#include "equilibrium/velocity_program.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr double largest_velocity_error = 1e-8;

    /// Of the force that has been minimised and that of the velocities.
    constexpr double largest_loss = 1e-3;



    VelocityField
    find_mechanism(const PlaneBody &body)
    {
      try
        {
          return body.kinematics == Kinematics::plane_stress ?
                   find_motion_of_sheet(body) :
                   find_stream(body);
        }
      catch (const UnboundedError &)
        {
          throw ConvergenceError(
            "No velocity moves the whole indenter down: it reaches a point "
            "that is held, or the supports enclose the body. Let "
            "'Indenter/Reach' end before what is held. (Mechanisms that change "
            "the volume of a hole are not looked for.)");
        }
    }



    // The indenter then moves down by 1.
    void
    scale(VelocityField &field, const double factor)
    {
      for (TriangleVelocity &velocity : field.velocity)
        {
          for (Tensor<1, 2> &coefficient : velocity.coefficients)
            coefficient *= factor;
          velocity.flux *= factor;
        }
    }
  } // namespace



  VelocityField
  minimize_plastic_work(const PlaneBody &body)
  {
    VelocityField field   = find_mechanism(body);
    const double  minimum = field.force;
    const double  depth   = lowest_depth(body, field.velocity);
    if (!(depth > 0. && std::isfinite(depth)))
      throw ConvergenceError(
        "No mechanism of collapse has been found that moves the whole indenter "
        "down, because of rounding errors.");
    scale(field, 1. / depth);

    field.error = check_velocity(body, field.velocity).largest();
    if (!(field.error <= largest_velocity_error))
      throw ConvergenceError(
        "The mechanism of collapse violates its conditions by " +
        Patterns::Tools::to_string(field.error) +
        " of the indenter's velocity, because of rounding errors.");
    field.dissipation = plastic_work(body, field.velocity);
    field.force =
      std::accumulate(field.dissipation.begin(), field.dissipation.end(), 0.) -
      power_of_tractions(body, field.velocity);
    if (!(field.force - minimum <= largest_loss * std::abs(minimum)))
      field.is_optimal = false;
    return field;
  }
} // namespace ElastoPlastic
