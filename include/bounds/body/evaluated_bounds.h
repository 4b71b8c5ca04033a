// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_evaluated_bounds_h
#define bounds_body_evaluated_bounds_h

#include <cmath>
#include <numeric>
#include <string>

#include "base/exceptions.h"
#include "base/text.h"
#include "bounds/body/loads.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/tolerances.h"

// What turns the solutions of conic programs into bounds, in the plane as in
// space: by independent checks of the fields themselves.

namespace ElastoPlastic
{
  using namespace dealii;

  /// The result of @p maximize(), which looks for the stresses with the largest
  /// force. @throws ConvergenceError or EquilibriumError that says why there
  /// are none.
  template <typename Maximize>
  auto
  explain_missing_limit(const Maximize &maximize)
  {
    try
      {
        return maximize();
      }
    catch (const UnboundedError &)
      {
        throw ConvergenceError(
          "There is no limit load: the supports enclose the body, which bears "
          "any load, or the indenter reaches a point that is held. Let "
          "'Indenter/Reach' end before what is held.");
      }
    catch (const NoSolutionError &)
      {
        throw EquilibriumError(
          "No stresses on this mesh bear the constant loads alone, those in "
          "'Boundary conditions/Traction' and 'Body force'. Prescribe smaller "
          "ones, begin with a finer mesh if the body should just bear them, or "
          "look for the part of them that it bears with 'Limit load/Load = "
          "tractions'.");
      }
  }



  /// The largest error that check_stress() finds, which must not be more than
  /// rounding. @throws ConvergenceError if it is: nothing follows from such
  /// stresses.
  template <typename Body, typename Field>
  double
  require_admissible(const Body &body, const Field &field)
  {
    const double error = check_stress(body, field).largest();
    if (error > Tolerance::admissibility)
      throw ConvergenceError(
        "The stresses of the equilibrium method violate equilibrium or yield "
        "condition by " +
        to_text(error) +
        " of the yield stress. If this is more than rounding, look at the "
        "tractions: on each side of a triangle, or face of a tetrahedron, they "
        "must be polynomials of the degree of the stresses, in a body of "
        "revolution when multiplied by r.");
    return error;
  }



  /// Scales the velocities of a @p field, which is up to a factor, so that the
  /// indenter moves down by 1, or if it is other loads that grow, the largest
  /// velocity is 1; and replaces the bound that has been minimised by that
  /// which follows from the velocities alone.
  /// @throws ConvergenceError if they are no admissible mechanism.
  template <typename Body, typename Field>
  void
  evaluate_mechanism(const Body &body, Field &field)
  {
    // (Without friction, velocities are those of a stream function, or no
    // volume counts; with it, rates are inside a cone as far as they have been
    // computed.)
    const double largest_error = body.has_friction() ?
                                   Tolerance::admissibility_with_friction :
                                   Tolerance::admissibility;

    const bool   loads_grow = body.load_factor_unit > 0;
    const double minimum    = field.bound;
    const double size = loads_grow ? largest_velocity(body, field.velocity) :
                                     lowest_depth(body, field.velocity);
    if (!(size > 0. && std::isfinite(size)))
      throw ConvergenceError(
        "No mechanism of collapse has been found, because of rounding errors.");
    scale(field, 1. / size);

    field.error = check_velocity(body, field.velocity).largest();
    if (!(field.error <= largest_error))
      throw ConvergenceError(
        "The mechanism of collapse violates its conditions by " +
        to_text(field.error) + " of its velocity, because of rounding errors.");

    const LoadPower power = power_of_loads(body, field.velocity);
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
} // namespace ElastoPlastic

#endif
