// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <sstream>

#include "base/exceptions.h"
#include "bounds/body/hencky_material.h"
#include "bounds/limit_load_analysis.h"
#include "bounds/safe_load.h"
#include "output/log.h"
#include "problem/load_history.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The search begins on a coarse mesh, and refines few cells at a time.
    constexpr types::global_cell_index max_initial_cells = 150;



    bool
    has_limit_load(const Model<2> &model)
    {
      return !model.strain_model.is_finite() &&
             !model.strain_model.has_general_criteria &&
             model.contact.friction_coefficient() == 0. &&
             !(model.body_force.is_present() &&
               model.strain_model.kinematics == Kinematics::plane_stress) &&
             std::all_of(model.materials.begin(),
                         model.materials.end(),
                         is_perfect) &&
             std::all_of(model.materials.begin(),
                         model.materials.end(),
                         HenckyMaterial::yields);
    }



    /// What a limit load is to be compared with, if there is any: the largest
    /// force of the indenter, or without indenter, all other loads. A force
    /// that a depth has reached, and from which the next segment begins, is
    /// safe.
    std::optional<LoadInQuestion>
    load_in_question(const Model<2> &model, const Parameters &parameters)
    {
      const bool has_other_loads =
        !model.boundary_conditions.tractions().empty() ||
        model.body_force.is_present();
      if (!has_limit_load(model) ||
          has_other_loads == (model.indenter.shape != nullptr))
        return {};
      const TimeSteps steps(model.load_program.segment_ends(),
                            parameters.loading.n_steps,
                            0);
      if (has_other_loads)
        return LoadInQuestion{0., steps.uncut_ends()};
      const double force =
        largest_load(model.load_program, steps, Control::force).value_or(0.);
      return force > 0 ? std::make_optional(LoadInQuestion{force, {}}) :
                         std::nullopt;
    }



    Parameters
    with_refinement_of_few_cells(const Parameters &parameters)
    {
      Parameters result                     = parameters;
      result.refinement                     = RefinementParameters();
      result.refinement.refinement_fraction = 0.1;
      if (result.output.screen == Verbosity::summary)
        result.output.screen = Verbosity::quiet; // a table of load steps
      return result;
    }



    // What the conic programs cannot find says nothing about the force: the
    // body may be enclosed and have no limit load at all, or have no mechanism
    // that bounds it; the rounding errors may be too large. Nor does it if the
    // equilibrium method does not know a load. Then it is for the load steps to
    // find out.
    template <typename Look>
    std::string
    reason_without_bounds(const Look &look)
    {
      try
        {
          look();
          return "";
        }
      catch (const ConvergenceError &error)
        {
          return error.what();
        }
      catch (const InputError &error)
        {
          return error.what();
        }
    }
  } // namespace



  template <>
  void
  require_safe_load(const Model<2>   &model,
                    const Parameters &parameters,
                    const MPI_Comm    communicator)
  {
    const auto load = load_in_question(model, parameters);
    if (!load)
      return;

    const Model<2>    coarse_model = model.with_few_cells(max_initial_cells);
    const Parameters  few_cells    = with_refinement_of_few_cells(parameters);
    const std::string reason       = reason_without_bounds([&]() {
      LimitLoadAnalysis(coarse_model, few_cells, communicator)
        .require_safe(*load);
    });
    if (!reason.empty())
      Log(communicator, Verbosity::quiet)
        .warn("There is no bound of the limit load to compare " +
              load->in_words() + " with. " + reason +
              " The load is applied all the same; beyond a limit load, it "
              "finds no equilibrium.");
  }



  template <>
  std::string
  first_look_at_load(const Model<2>   &model,
                     const Parameters &parameters,
                     const MPI_Comm    communicator)
  {
    const auto load = load_in_question(model, parameters);
    if (!load)
      return "";

    const Model<2>    coarse_model = model.with_few_cells(max_initial_cells);
    const Parameters  few_cells    = with_refinement_of_few_cells(parameters);
    bool              is_safe      = false;
    const std::string reason       = reason_without_bounds([&]() {
      is_safe = LimitLoadAnalysis(coarse_model, few_cells, communicator)
                  .is_safe_at_first_sight(*load);
    });
    if (!reason.empty())
      return "there is no bound to compare " + load->in_words() + " with. " +
             reason;
    return is_safe ? load->in_words() + " is below the limit load" :
                     "a coarse mesh does not tell whether " + load->in_words() +
                       " is below it; the run begins with finding out";
  }



  // In space, bounds that are close enough to decide take minutes or more.
  template <>
  void
  require_safe_load(const Model<3> &, const Parameters &, const MPI_Comm)
  {}



  template <>
  std::string
  first_look_at_load(const Model<3> &, const Parameters &, const MPI_Comm)
  {
    return "";
  }



  namespace
  {
    /// What to say if no limit load explains it.
    template <int dim>
    ConvergenceError
    failure_of(const FailedStep<dim>  &step,
               const ConvergenceError &error,
               const SolveResult      &last)
    {
      if (step.is_single)
        return error;
      return ConvergenceError(
        "Load step " + std::to_string(step.number) +
        " from t = " + Patterns::Tools::to_string(step.begin) + " (depth " +
        Patterns::Tools::to_string(last.depth) + ") fails even if it ends at " +
        "t = " + Patterns::Tools::to_string(step.end) +
        ", and 'Loading/Maximum number of cuts' allows for no shorter one. " +
        error.what());
    }
  } // namespace



  template <int dim>
  void
  give_up_step(const ConvergenceError &error,
               const FailedStep<dim>  &step,
               const SolveResult      &last)
  {
    const bool  force_grows = step.force > last.force;
    const auto &materials   = step.model.materials;
    if (std::none_of(materials.begin(), materials.end(), has_limit) ||
        !(force_grows || step.tractions_grow))
      throw failure_of(step, error, last);

    const std::string where =
      "to be beyond the limit load of the body, whose material stops "
      "hardening. ";
    std::ostringstream message;
    message.precision(10);
    message << "No equilibrium has been found ";
    if (force_grows)
      message << "for the force " << step.force << " (t = " << step.end
              << "): it seems " << where << "The largest force reached is "
              << last.force << ", at the depth " << last.depth
              << ". Prescribe the depth, or a smaller force";
    else
      message << "under the tractions and body forces at t = " << step.end
              << ": they seem " << where
              << "The last equilibrium is that at t = " << last.time
              << ". Prescribe smaller ones ('Boundary conditions/Traction', "
                 "'Body force'), or displacements instead";
    message << "; several load steps come closer to the limit.";
    throw EquilibriumError(message.str());
  }



  template void
  give_up_step(const ConvergenceError &,
               const FailedStep<2> &,
               const SolveResult &);
  template void
  give_up_step(const ConvergenceError &,
               const FailedStep<3> &,
               const SolveResult &);
} // namespace ElastoPlastic
