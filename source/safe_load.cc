// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <sstream>

#include "base/exceptions.h"
#include "equilibrium/hencky_material.h"
#include "io/log.h"
#include "limit_load_analysis.h"
#include "loading/time_steps.h"
#include "safe_load.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The search begins on a coarse mesh, and refines few cells at a time.
    constexpr types::global_cell_index max_initial_cells = 150;



    bool
    has_limit_load(const Model<2> &model)
    {
      return model.strain_model.kinematics != Kinematics::axisymmetric &&
             model.indenter.shape &&
             model.boundary_conditions.tractions().empty() &&
             std::all_of(model.materials.begin(),
                         model.materials.end(),
                         is_perfect) &&
             std::all_of(model.materials.begin(),
                         model.materials.end(),
                         HenckyMaterial::yields);
    }



    /// Of all that are prescribed at the ends of the load steps. A force that
    /// a depth has reached, and from which the next segment begins, is safe.
    double
    largest_force(const LoadProgram &program, const unsigned int n_steps)
    {
      double largest = 0;
      for (TimeSteps steps(program.segment_ends(), n_steps, 0);
           !steps.finished();
           steps.advance())
        {
          const auto load = program.load(steps.next_time());
          if (load && load->control == Control::force)
            largest = std::max(largest, load->value);
        }
      return largest;
    }
  } // namespace



  // What the conic programs cannot find says nothing about the force: the body
  // may be enclosed and have no limit load at all, or have no mechanism that
  // bounds it; the rounding errors may be too large. Then it is for the load
  // steps to find out.
  template <>
  void
  require_safe_load(const Model<2>   &model,
                    const Parameters &parameters,
                    const MPI_Comm    communicator)
  {
    const double force =
      largest_force(model.load_program, parameters.loading.n_steps);
    if (force <= 0 || !has_limit_load(model))
      return;

    Model<2>   coarse_model                      = model;
    Parameters few_at_a_time                     = parameters;
    few_at_a_time.refinement                     = RefinementParameters();
    few_at_a_time.refinement.refinement_fraction = 0.1;
    try
      {
        while (true)
          {
            LimitLoadAnalysis  analysis(coarse_model,
                                       few_at_a_time,
                                       communicator);
            const unsigned int n =
              coarse_model.geometry.n_initial_refinements();
            if (n == 0 || analysis.n_cells() <= max_initial_cells)
              return analysis.require_safe(force);
            coarse_model.geometry =
              coarse_model.geometry.with_initial_refinements(n - 1);
          }
      }
    catch (const ConvergenceError &error)
      {
        Log(communicator, Verbosity::quiet)
          .warn("There is no bound of the limit load to compare the force " +
                Patterns::Tools::to_string(force) + " with. " + error.what() +
                " The load is applied all the same; beyond a limit load, it "
                "finds no equilibrium.");
      }
  }



  // Nothing is known in space.
  template <>
  void
  require_safe_load(const Model<3> &, const Parameters &, const MPI_Comm)
  {}



  template <int dim>
  void
  give_up_step(const ConvergenceError &error,
               const Model<dim>       &model,
               const AskedFor         &step,
               const bool              tractions_grow,
               const SolveResult      &last)
  {
    const bool  force_grows = step.force > last.force;
    const auto &materials   = model.materials;
    if (std::none_of(materials.begin(), materials.end(), has_limit) ||
        !(force_grows || tractions_grow))
      throw error;

    const std::string where =
      "to be beyond the limit load of the body, whose material stops "
      "hardening. ";
    std::ostringstream message;
    message.precision(10);
    message << "No equilibrium has been found ";
    if (force_grows)
      message << "for the force " << step.force << " (t = " << step.time
              << "): it seems " << where << "The largest force reached is "
              << last.force << ", at the depth " << last.depth
              << ". Prescribe the depth, or a smaller force";
    else
      message << "under the tractions at t = " << step.time << ": they seem "
              << where << "The last equilibrium is that at t = " << last.time
              << ". Prescribe smaller tractions ('Boundary "
                 "conditions/Traction'), or displacements instead";
    message << "; several load steps come closer to the limit.";
    throw EquilibriumError(message.str());
  }



  template void
  give_up_step(const ConvergenceError &,
               const Model<2> &,
               const AskedFor &,
               const bool,
               const SolveResult &);
  template void
  give_up_step(const ConvergenceError &,
               const Model<3> &,
               const AskedFor &,
               const bool,
               const SolveResult &);
} // namespace ElastoPlastic
