// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "base/exceptions.h"
#include "contact/coulomb_friction.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int n>
    double
    length(const Tensor<1, n> &v, const Tensor<1, n> &slope)
    {
      return std::sqrt(tangent_product(v, v, slope));
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
  CoulombFriction<dim>::CoulombFriction(const double coefficient)
    : coefficient(coefficient)
  {}



  template <int dim>
  bool
  CoulombFriction<dim>::update(FrictionState<dim>       &state,
                               const ContactForce<dim>  &force,
                               const TangentVector<dim> &slip,
                               const TangentVector<dim> &slope,
                               const double              share) const
  {
    if (!dissipates())
      return false;
    if (state.sticks)
      {
        const double tangential = length(force.tangential, slope);
        if (tangential <= coefficient * share * force.normal)
          return false;
        state = {false, force.tangential / tangential};
        return true;
      }
    if (tangent_product(slip, state.direction, slope) > 0.)
      {
        state.direction = slip / length(slip, slope);
        return false;
      }
    state = {};
    return true;
  }



  // With the normal m = (-b, 1)/L, L^2 = 1 + b^2, and the unit vector s of the
  // slip, the force is N (m + mu s), and its horizontal part -(b - mu L s) / (1
  // + mu L b.s) times the vertical one.
  template <int dim>
  ForceSlope<dim>
  CoulombFriction<dim>::force_slope(const IndenterSurface<dim> &surface,
                                    const FrictionState<dim>   &state,
                                    const TangentVector<dim>   &slip,
                                    const double                share) const
  {
    const double              mu = coefficient * share;
    const TangentVector<dim> &b  = surface.slope;
    const double              L  = std::sqrt(1. + b * b);
    const bool turns = tangent_product(slip, state.direction, b) > 0.;
    const TangentVector<dim> &v        = turns ? slip : state.direction;
    const double              n        = length(v, b);
    const TangentVector<dim>  e        = L / n * v; // L s
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
        TangentVector<dim> change_of_b, change_of_v;
        for (unsigned int i = 0; i < dim - 1; ++i)
          change_of_b[i] = surface.curvature[i][j];
        if (turns)
          change_of_v[j] = 1.;
        const double change_of_n =
          (tangent_product(v, change_of_v, b) + (b * v) * (v * change_of_b)) /
          n;
        const TangentVector<dim> change_of_e =
          (b * change_of_b) / (L * L) * e +
          (L * change_of_v - change_of_n * e) / n;
        const TangentVector<dim> change =
          (change_of_b - mu * change_of_e -
           mu * (change_of_b * e + b * change_of_e) * result.value) /
          quotient;
        for (unsigned int i = 0; i < dim - 1; ++i)
          result.derivative[i][j] = change[i];
      }
    return result;
  }



  template struct ContactForce<2>;
  template struct ContactForce<3>;
  template class CoulombFriction<2>;
  template class CoulombFriction<3>;
} // namespace ElastoPlastic
