// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Coulomb's law at one node: the force that follows from its slope has the
// angle of friction with the normal of the indenter and lies in the direction
// of the slip; its derivatives are those of difference quotients; nodes switch
// between stick and slip as the law says.

#include <deal.II/base/mpi.h>

#include <cmath>

#include "base/exceptions.h"
#include "contact/coulomb_friction.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  constexpr double mu = 0.3;



  template <int dim>
  TangentVector<dim>
  vector(const double x, const double y)
  {
    TangentVector<dim> result;
    result[0] = x;
    if (dim == 3)
      result[dim - 2] = y;
    return result;
  }



  /// The surface above a point that has moved by x.
  template <int dim>
  IndenterSurface<dim>
  surface(const TangentVector<dim> &x)
  {
    IndenterSurface<dim> result{0., vector<dim>(0.4, -0.2), {}};
    for (unsigned int i = 0; i < dim - 1; ++i)
      for (unsigned int j = 0; j < dim - 1; ++j)
        {
          result.curvature[i][j] = i == j ? 1. - 0.5 * i : 0.3;
          result.slope[i] += result.curvature[i][j] * x[j];
        }
    return result;
  }



  /// Whether friction that is a little larger holds a node, and one that is a
  /// little smaller does not.
  template <int dim>
  bool
  is_at_limit(const ContactForce<dim> &force, const TangentVector<dim> &slope)
  {
    const auto sticks = [&](const double coefficient) {
      FrictionState<dim> state;
      CoulombFriction<dim>(coefficient, 1.).update(state, force, {}, slope, 1.);
      return state.sticks;
    };
    return sticks((1. + 1e-8) * mu) && !sticks((1. - 1e-8) * mu);
  }



  template <int dim>
  void
  check_force()
  {
    const CoulombFriction<dim> friction(mu, 1.);
    const TangentVector<dim>   slip = vector<dim>(-0.02, 0.05);
    const auto                 here = surface<dim>({});
    const TangentVector<dim>  &b    = here.slope;
    FrictionState<dim>         state;
    const double               way = std::sqrt(tangent_product(slip, slip, b));
    state                          = {false, slip / way, 1. / way};

    const auto              law = friction.force_slope(here, state, slip);
    const ContactForce<dim> force(2., -2. * law.value, b);
    const double            tangential =
      std::sqrt(tangent_product(force.tangential, force.tangential, b));
    verify("  tangential over normal force",
           std::abs(tangential / force.normal - mu),
           1e-14);
    verify("  at the limit of the switching test", is_at_limit(force, b));
    verify("  in the direction of the slip",
           (force.tangential / tangential - state.direction).norm(),
           1e-14);

    constexpr double   h          = 1e-5;
    Tensor<2, dim - 1> difference = law.derivative;
    for (unsigned int j = 0; j < dim - 1; ++j)
      {
        TangentVector<dim> step;
        step[j]       = h;
        const auto at = [&](const TangentVector<dim> &x) {
          return friction.force_slope(surface<dim>(x), state, slip + x).value;
        };
        const auto quotient = (at(step) - at(-step)) / (2. * h);
        for (unsigned int i = 0; i < dim - 1; ++i)
          difference[i][j] -= quotient[i];
      }
    verify("  derivative", difference.norm() / law.derivative.norm(), 1e-6);
  }



  /// A node that has been torn off twice slips when it comes back, and sticks
  /// again in the next load step.
  template <int dim>
  void
  check_release(const CoulombFriction<dim> &friction)
  {
    const TangentVector<dim> slip = vector<dim>(1e-3, 0.), flat;
    FrictionState<dim>       state;
    for (const bool sticks : {true, true, false})
      {
        friction.touch(state, slip, flat, 1.);
        verify("  sticks or slips", state.sticks == sticks);
        friction.release(state);
      }
    friction.begin_step(state, true);
    friction.touch(state, slip, flat, 1.);
    verify("  sticks in the next step", state.sticks);
  }



  /// Without a law, what touches when a load step begins sticks, and no other
  /// node does.
  template <int dim>
  void
  check_beginning(const CoulombFriction<dim> &stick)
  {
    FrictionState<dim> state;
    for (const bool touches : {false, true})
      {
        stick.begin_step(state, touches);
        verify("  sticks or not", state.sticks == touches);
      }
  }



  template <int dim>
  void
  check_switching()
  {
    const CoulombFriction<dim> friction(mu, 1.);
    const TangentVector<dim>   none, flat;
    FrictionState<dim>         state;
    verify("  sticks below the limit",
           !friction.update(
             state, {1., vector<dim>(0.2, 0.2), flat}, none, flat, 1.) &&
             state.sticks);
    verify("  slips beyond it",
           friction.update(
             state, {1., vector<dim>(-0.4, 0.), flat}, none, flat, 1.) &&
             !state.sticks && state.direction[0] == -1.);
    verify("  goes on",
           !friction.update(state,
                            {1., vector<dim>(-0.3, 0.), flat},
                            vector<dim>(-0.1, 0.1),
                            flat,
                            1.) &&
             !state.sticks);
    verify("  sticks where friction would drive it",
           friction.update(state,
                           {1., vector<dim>(-0.3, 0.), flat},
                           vector<dim>(0.1, 0.),
                           flat,
                           1.) &&
             state.sticks);
    state = {};
    verify("  says how far it was beyond",
           std::abs(
             friction.update(
               state, {1., vector<dim>(-0.4, 0.), flat}, none, flat, 1.) -
             (0.4 - mu)),
           1e-15);
    verify("  never slips",
           !CoulombFriction<dim>(std::numeric_limits<double>::infinity(), 1.)
              .update(state, {1., vector<dim>(9., 0.), flat}, none, flat, 1.));
    check_release(friction);
    check_beginning(
      CoulombFriction<dim>(std::numeric_limits<double>::infinity(), 1.));
  }



  template <int dim>
  void
  check()
  {
    output() << dim << "D" << std::endl;
    check_force<dim>();
    check_switching<dim>();
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check<2>();
  check<3>();

  IndenterSurface<2> steep{0., {}, {}};
  steep.slope[0] = -4.;
  FrictionState<2> state;
  state.sticks       = false;
  state.direction[0] = 1. / std::sqrt(17.);
  try
    {
      CoulombFriction<2>(mu, 1.).force_slope(steep, state, state.direction);
      output() << "not refused" << std::endl;
    }
  catch (const ConvergenceError &error)
    {
      output() << error.what() << std::endl;
    }
}
