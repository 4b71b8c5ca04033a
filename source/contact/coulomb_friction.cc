// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "contact/coulomb_friction.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A force that exceeds friction by less than this part of it does not make
    /// a node slip.
    constexpr double rounding = 1e-9;
    /// As if it exceeded friction by so much at least, turns the direction of a
    /// node that slips: otherwise the linear systems have springs that are too
    /// stiff.
    constexpr double smallest_excess = 1e-3;
    /// With a larger coefficient, the law makes a force that is by far too
    /// large of a normal one that is not yet right.
    constexpr double largest_trusted = 1.;
    /// In one load step, of one node; more are no accident of the first
    /// iterations.
    constexpr unsigned int tolerated_releases = 1;



    template <int n>
    double
    length(const Tensor<1, n> &v, const Tensor<1, n> &slope)
    {
      return std::sqrt(tangent_product(v, v, slope));
    }



    /// The part of @p v across the direction @p s.
    template <int n>
    Tensor<1, n>
    across(const Tensor<1, n> &v,
           const Tensor<1, n> &s,
           const Tensor<1, n> &slope)
    {
      return v - tangent_product(v, s, slope) * s;
    }



    /// That of the force of a node that slips: to first order, it turns with
    /// the slip.
    template <int dim>
    TangentVector<dim>
    slip_direction(const FrictionState<dim> &state,
                   const TangentVector<dim> &slip,
                   const TangentVector<dim> &slope)
    {
      const auto s = state.direction / length(state.direction, slope);
      return s + state.turning * across(slip, s, slope);
    }
  } // namespace



  template <int dim>
  ContactForce<dim>::ContactForce(const double              vertical,
                                  const TangentVector<dim> &horizontal,
                                  const TangentVector<dim> &slope)
    : normal((vertical - slope * horizontal) / std::sqrt(1. + slope * slope))
    , tangential(horizontal + normal / std::sqrt(1. + slope * slope) * slope)
  {}



  template <int dim>
  std::uint64_t
  FrictionState<dim>::fingerprint() const
  {
    std::uint64_t number = sticks ? 0 : 1;
    for (unsigned int d = 0; d < dim - 1; ++d)
      number = 512 * number + std::lround(100. * direction[d] + 256.);
    return sticks ? 0 : number;
  }



  template <int dim>
  void
  CoulombFriction<dim>::begin_step(FrictionState<dim> &state,
                                   const bool          touches) const
  {
    if (!dissipates())
      state = {touches, {}, 0., 0};
    state.n_releases = 0;
  }



  template <int dim>
  void
  CoulombFriction<dim>::touch(FrictionState<dim>       &state,
                              const TangentVector<dim> &slip,
                              const TangentVector<dim> &slope,
                              const double              penetration) const
  {
    if (!dissipates())
      return;
    const double way   = length(slip, slope);
    const double force = state.n_releases > tolerated_releases ?
                           0. :
                           coefficient * std::max(penetration, 0.);
    state = way <= force ? FrictionState<dim>{true, {}, 0., state.n_releases} :
                           FrictionState<dim>{false,
                                              slip / way,
                                              1. / (way - force),
                                              state.n_releases};
  }



  // (With forces t and friction f, the derivative of t = f (t + c w)/|t + c w|
  // demands that the part of t across that direction be c f/(|t + c w| - f)
  // times that of w. The force of a node that slips is that of the law: until
  // Newton's method has converged, the force of the body is another one, and
  // would make it stick and slip in turn.)
  template <int dim>
  double
  CoulombFriction<dim>::update(FrictionState<dim>       &state,
                               const ContactForce<dim>  &force,
                               const TangentVector<dim> &slip,
                               const TangentVector<dim> &slope,
                               const double              extent) const
  {
    if (!dissipates())
      return 0.;
    const double             stiffness = modulus * extent;
    const bool               has_stuck = state.sticks;
    const double             limit     = coefficient * force.normal;
    const TangentVector<dim> own = has_stuck || coefficient > largest_trusted ?
                                     force.tangential :
                                     limit * slip_direction(state, slip, slope);
    const TangentVector<dim> trial     = own + stiffness * slip;
    const double             magnitude = length(trial, slope);
    const bool               turns_back =
      !state.sticks && tangent_product(trial, state.direction, slope) < 0.;
    if (magnitude <= (1. + rounding) * limit || turns_back || magnitude == 0.)
      state = {true, {}, 0., state.n_releases};
    else
      state = {false,
               trial / magnitude,
               stiffness / std::max(magnitude - limit, smallest_excess * limit),
               state.n_releases};
    return state.sticks != has_stuck ?
             std::max(std::abs(magnitude - limit),
                      std::numeric_limits<double>::min()) :
             0.;
  }



  // With the normal m = (-b, 1)/L, L^2 = 1 + b^2, the direction s of the slip
  // and e = L s, the force N m + mu N s has the horizontal part
  // -(b - mu e) / (1 + mu b.e) times its vertical one.
  template <int dim>
  ForceSlope<dim>
  CoulombFriction<dim>::force_slope(const IndenterSurface<dim> &surface,
                                    const FrictionState<dim>   &state,
                                    const TangentVector<dim>   &slip) const
  {
    const double              mu = coefficient;
    const TangentVector<dim> &b  = surface.slope;
    const double              L  = std::sqrt(1. + b * b);
    const TangentVector<dim>  s  = state.direction / length(state.direction, b);
    const TangentVector<dim>  e  = L * slip_direction(state, slip, b);
    const double              quotient = 1. + mu * (b * e);
    if (!(quotient > 0.))
      throw ConvergenceError(
        "The flank of the indenter is so steep that friction carries the whole "
        "force on it: its angle and that of friction together exceed 90 "
        "degrees. Check 'Contact/Friction coefficient' and 'Indenter'.");

    ForceSlope<dim> result;
    result.value = (b - mu * e) / quotient;
    for (unsigned int j = 0; j < dim - 1; ++j)
      {
        TangentVector<dim> change_of_b, change_of_slip;
        for (unsigned int i = 0; i < dim - 1; ++i)
          change_of_b[i] = surface.curvature[i][j];
        change_of_slip[j]      = 1.;
        const double shrinking = (b * s) * (s * change_of_b); // of s
        const double change_along =
          2. * shrinking * tangent_product(slip, s, b) -
          (change_of_b * slip) * (b * s) - (b * slip) * (s * change_of_b);
        const TangentVector<dim> change_of_e =
          (b * change_of_b) / (L * L) * e +
          L *
            (state.turning * (across(change_of_slip, s, b) + change_along * s) -
             shrinking * s);
        const double change_of_be = change_of_b * e + b * change_of_e;
        const TangentVector<dim> change =
          (change_of_b - mu * (change_of_e + change_of_be * result.value)) /
          quotient;
        for (unsigned int i = 0; i < dim - 1; ++i)
          result.derivative[i][j] = change[i];
      }
    return result;
  }



  template struct ContactForce<2>;
  template struct ContactForce<3>;
  template struct FrictionState<2>;
  template struct FrictionState<3>;
  template class CoulombFriction<2>;
  template class CoulombFriction<3>;
} // namespace ElastoPlastic
