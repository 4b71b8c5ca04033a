// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "equilibrium/certificate.h"
#include "equilibrium/load_power.h"
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
            body.load_factor_unit > 0 ?
              "No velocity lets the loads that grow do work: the supports "
              "enclose the body. (Mechanisms that change the volume of a hole "
              "are not looked for.)" :
              "No velocity moves the whole indenter down: it reaches a point "
              "that is held, or the supports enclose the body. Let "
              "'Indenter/Reach' end before what is held. (Mechanisms that "
              "change the volume of a hole are not looked for.)");
        }
    }



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



    double
    largest_velocity(const PlaneBody &body, const VelocityField &field)
    {
      double largest = 0;
      for (unsigned int t = 0; t < field.velocity.size(); ++t)
        for (const Tensor<1, 2> &velocity :
             values_at_vertices(body, field.velocity[t], t))
          largest = std::max(largest, velocity.norm());
      return largest;
    }



    /// Scales a velocity as VelocityField::velocity says.
    void
    normalize(VelocityField &field, const PlaneBody &body)
    {
      const double size = body.load_factor_unit > 0 ?
                            largest_velocity(body, field) :
                            lowest_depth(body, field.velocity);
      if (!(size > 0. && std::isfinite(size)))
        throw ConvergenceError(
          "No mechanism of collapse has been found, because of rounding "
          "errors.");
      scale(field, 1. / size);
    }



    void
    find_bound(VelocityField &field, const PlaneBody &body)
    {
      const LoadPower power = power_of_loads(body, field.velocity);
      field.dissipation     = plastic_work(body, field.velocity);
      const double missing  = std::accumulate(field.dissipation.begin(),
                                             field.dissipation.end(),
                                             -power.constant);
      field.bound =
        body.load_factor_unit > 0 ? missing / power.growing : missing;
      if (body.load_factor_unit > 0 && !(power.growing > 0))
        throw ConvergenceError(
          "The loads that grow have no power in the mechanism of collapse, "
          "because of rounding errors.");
    }
  } // namespace



  VelocityField
  minimize_plastic_work(const PlaneBody &body)
  {
    VelocityField field   = find_mechanism(body);
    const double  minimum = field.bound;
    normalize(field, body);
    field.error = check_velocity(body, field.velocity).largest();
    if (!(field.error <= largest_velocity_error))
      throw ConvergenceError(
        "The mechanism of collapse violates its conditions by " +
        Patterns::Tools::to_string(field.error) +
        " of its velocity, because of rounding errors.");
    find_bound(field, body);
    if (!(field.bound - minimum <= largest_loss * std::abs(minimum)))
      field.is_optimal = false;
    return field;
  }
} // namespace ElastoPlastic
