// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The stress that the body bears before the first step.

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/exceptions.h"
#include "contact_run/discrete_body.h"
#include "mesh/body_size.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Forces that would change the stress by so much are what rounding leaves.
    constexpr double rounding = 1e-12;

    /// Of what is out of balance, a linear system is to leave so much. With
    /// finite strains, the response of a small strain is that of the strain up
    /// to its square: the next system takes the rest.
    constexpr double       reduction      = 1e-8;
    constexpr unsigned int max_iterations = 10;

    /// What is out of balance by more is not meant.
    constexpr double largest_imbalance = 0.1;

    /// Nobody would ask what has been corrected by less.
    constexpr double visible_imbalance = 1e-6;



    std::string
    percent(const double part)
    {
      std::ostringstream text;
      text.precision(3);
      text << 100. * part << " %";
      return text.str();
    }



    /// What the elastic energy of the response to @p forces would be if each
    /// node moved alone.
    double
    energy_scale(const VectorType &forces, const VectorType &diagonal)
    {
      double sum = 0;
      for (unsigned int i = 0; i < forces.locally_owned_size(); ++i)
        if (diagonal.local_element(i) > 0)
          sum += 0.5 * forces.local_element(i) * forces.local_element(i) /
                 diagonal.local_element(i);
      return Utilities::MPI::sum(sum, forces.get_mpi_communicator());
    }
  } // namespace



  // No time passes: the body is elastic, without a stress until that is set.
  template <int dim>
  void
  DiscreteBody<dim>::set_initial_stress()
  {
    if (!model.initial_stress.is_present())
      return;
    TimerOutput::Scope scope(timer, "Initial stress");

    const double duration = solid_body.step_duration();
    solid_body.begin_step(0.);
    VectorType rest;
    solid_body.initialize_vector(rest);
    solid_body.linearize(rest);
    solid_body.set_initial_stress(model.initial_stress);
    const double energy = solid_body.initial_stress_size().energy;
    if (energy > 0.)
      initial_imbalance = std::sqrt(
        balance_initial_stress(external_forces_at(0.), energy) / energy);
    if (initial_imbalance > largest_imbalance)
      throw InputError(
        "The 'Initial stress' is not in equilibrium with supports and loads: "
        "at t = 0, " +
        percent(initial_imbalance) +
        " of it (in the norm of the elastic energy) has nothing that "
        "balances it. Its divergence must be minus the body force, and on "
        "boundaries that are free, of contact or under tractions, its normal "
        "component must be the traction at t = 0. Up to 10 % is corrected. "
        "Give the body tractions or rollers that bear the stress, or refine "
        "the mesh where it varies.");
    solid_body.initialize_vector(initial_forces);
    solid_body.internal_forces(initial_forces, rest);
    solid_body.begin_step(duration);
    solid_body.predict_flow(u, u);
  }



  template <int dim>
  double
  DiscreteBody<dim>::balance_initial_stress(const VectorType &loads_at_rest,
                                            const double      energy)
  {
    VectorType rest, forces, diagonal, correction, first_forces, sum;
    for (VectorType *vector :
         {&rest, &forces, &diagonal, &correction, &first_forces, &sum})
      solid_body.initialize_vector(*vector);
    solid_body.diagonal(diagonal);
    const ReducedUnknowns unknowns_at_rest(held.fixed_entries(rest),
                                           {},
                                           rest.get_mpi_communicator());
    for (unsigned int n = 0; n < max_iterations; ++n)
      {
        solid_body.internal_forces(forces, rest);
        forces.sadd(-1., 1., loads_at_rest);
        unknowns_at_rest.contract(forces);
        if (energy_scale(forces, diagonal) <= rounding * rounding * energy)
          break;
        if (n == 0)
          {
            first_forces = forces;
            tangent_solver->prepare(unknowns_at_rest);
          }
        correction = 0.;
        tangent_solver->solve(correction, forces, reduction);
        unknowns_at_rest.expand(correction);
        held.constraints().distribute(correction);
        solid_body.add_to_initial_stress(correction);
        sum += correction;
      }
    return std::max(0., 0.5 * (first_forces * sum));
  }



  template <int dim>
  std::string
  DiscreteBody<dim>::remark_on_initial_stress() const
  {
    const std::string on_mesh =
      " in equilibrium with supports and loads at t = 0 on the first mesh";
    return initial_imbalance < visible_imbalance ?
             "The 'Initial stress' is" + on_mesh + "." :
             percent(initial_imbalance) +
               " of the 'Initial stress' (in the norm of the elastic energy) "
               "has not been" +
               on_mesh +
               ". The elastic response to what is missing has been added to "
               "it: the body begins at rest, in the shape of the mesh.";
  }



  // Force is stress times an area.
  template <int dim>
  double
  DiscreteBody<dim>::initial_force_scale() const
  {
    return solid_body.initial_stress_size().norm / body_size(mesh);
  }
} // namespace ElastoPlastic
