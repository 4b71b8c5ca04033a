// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/compatibility.h"
#include "base/exceptions.h"
#include "base/text.h"
#include "contact_run/step_evaluation.h"
#include "evaluation/step_guards.h"
#include "mechanics/rigid_body_modes.h"
#include "mesh/body_size.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A depth that follows from a force is none if the coordinates of the body
    /// would not show it.
    template <int dim>
    double
    depth_of_indenter(const DiscreteBody<dim> &body)
    {
      if (!body.gap_function().has_indenter())
        return 0.;
      const double depth = body.contact().depth();
      const bool   is_rounding =
        body.contact().is_force_driven() &&
        std::abs(depth) <= std::numeric_limits<double>::epsilon() *
                             body_size(body.triangulation());
      return is_rounding ? 0. : depth;
    }
  } // namespace



  template <int dim>
  StepEvaluation<dim>::StepEvaluation(const OutputParameters  &parameters,
                                      const DiscreteBody<dim> &body,
                                      Log                     &log,
                                      TimerOutput             &timer)
    : parameters(parameters)
    , body(body)
    , log(log)
    , timer(timer)
    , reactions(body.model, body.dof_handler(), body.supports())
    , boundary_displacements(body.model, body.triangulation())
    , probe_points(parameters.probe_points,
                   body.model.boundary_conditions.names(),
                   body.triangulation())
    , contact(body.model,
              body.model.indenter,
              body.triangulation(),
              body.gap_function())
    , imprint(contact, body.gap_function(), parameters.profile_lines)
    , small_strain_guard(contact)
    , pressure_guard(body.model.materials)
  {}



  template <int dim>
  RunTables::Names
  StepEvaluation<dim>::names() const
  {
    auto probes = boundary_displacements.names();
    for (const std::string &name : probe_points.names())
      probes.push_back(name);
    return {dim, reactions.names(), probes};
  }



  template <int dim>
  double
  StepEvaluation<dim>::measure(SolveResult    &result,
                               const LastStep &last_step) const
  {
    static_cast<ContactState &>(result) = body.contact_evaluation().state();
    static_cast<BodyState &>(result) =
      body_state(body.solid(), body.displacement());
    result.depth = depth_of_indenter(body);
    if (!body.model.strain_model.is_finite())
      require_bounded_flow(result);
    {
      TimerOutput::Scope scope(timer, "Evaluation");
      imprint.measure(result, body.contact_surface());
      if (body.model.strain_model.is_finite())
        measure_elements(result, last_step.result);
    }
    return check_force_balance(result, last_step.largest_forces);
  }



  // Elements that lock only a little bear a force beyond the limit load all the
  // same, as soon as the body has flown far enough. (Both are asked for: at a
  // corner of the indenter, strains have no limit on fine meshes, and a body
  // may be moved as a whole. Where the moduli are in units of the yield stress,
  // as in Johnson's examples, both may be a few times 1.)
  template <int dim>
  void
  StepEvaluation<dim>::require_bounded_flow(const SolveResult &result) const
  {
    constexpr double limit        = 10.;
    const double     strain       = result.max_equivalent_plastic_strain;
    const double     displacement = body.displacement().linfty_norm();
    const double     size         = body_size(body.triangulation());
    if (strain > limit && displacement > limit * size)
      throw ConvergenceError(
        "The body flows without end: its largest plastic strain would be " +
        to_text(strain) + ", its largest displacement " +
        to_text(displacement) + ", and its size is " + to_text(size) +
        ". Are the loads in the same system of units as the moduli in "
        "'Material', and below what the body can bear?");
  }



  // Force and contact hardly depend on such elements (doc/recipes,
  // "Finite strains"), so that the run goes on.
  template <int dim>
  void
  StepEvaluation<dim>::measure_elements(SolveResult       &result,
                                        const SolveResult &before) const
  {
    const ElementQuality<dim> worst =
      worst_element(body.dof_handler(), body.displacement());
    result.min_scaled_jacobian = worst.scaled_jacobian;
    if (worst.scaled_jacobian > 0. || before.min_scaled_jacobian <= 0.)
      return;
    log.warn("In step " + std::to_string(result.step) +
             " (t = " + Patterns::Tools::to_string(result.time) + ", depth " +
             Patterns::Tools::to_string(result.depth) +
             ") an element has a corner that is turned inside out, at (" +
             Patterns::Tools::to_string(worst.place) +
             ") of the deformed body; its scaled Jacobian is " +
             Patterns::Tools::to_string(worst.scaled_jacobian) +
             ". From here on, stresses and strains of the elements around are "
             "meaningless; force and contact area hardly depend on them. See "
             "doc/recipes/finite_strain.md.");
  }



  // The contact force, the sum of the residual over the active nodes, is
  // compared with what the supports feel, which is computed in an independent
  // way (Reactions); the difference is relative to the sum of all nodal forces,
  // because those of the supports may cancel, and to its largest value so far,
  // because after unloading there may be none.
  template <int dim>
  double
  StepEvaluation<dim>::check_force_balance(SolveResult &result,
                                           const double largest_before) const
  {
    const double reaction = reactions.vertical_force(body.solid(),
                                                     body.displacement(),
                                                     contact_forces(),
                                                     result.time);
    const double external = body.external_forces().l1_norm();
    double       load     = 0;
    if (external > 0)
      load = body.external_forces() *
             rigid_body_modes(body.dof_handler(), body.residual())[dim - 1];
    const double forces  = body.residual().l1_norm() + external;
    const double largest = std::max(largest_before, forces);
    if (largest > 0)
      result.force_balance_error =
        std::abs(result.force - reaction - load) / largest;
    return forces;
  }



  template <int dim>
  StepResult
  StepEvaluation<dim>::of_step(const SolveResult &result) const
  {
    TimerOutput::Scope scope(timer, "Evaluation");
    StepResult         step = {result,
                               reactions.compute(body.solid(),
                                         body.displacement(),
                                         contact_forces(),
                                         result.time),
                               boundary_displacements.compute(body.dof_handler(),
                                                      body.displacement()),
                               {}};
    for (const double value : probe_points.compute(body.dof_handler(),
                                                   body.solid(),
                                                   body.displacement()))
      step.probes.push_back(value);
    if (writes_surface_profile(result.time))
      step.surface_profile = imprint.profile(result, body.contact_surface());
    return step;
  }



  template <int dim>
  bool
  StepEvaluation<dim>::writes_surface_profile(const double time) const
  {
    const LoadProgram &program = body.model.load_program;
    switch (parameters.surface_profile)
      {
        case SurfaceProfileSteps::every_step:
          return true;
        case SurfaceProfileSteps::segment_ends:
          return program.is_segment_end(time);
        case SurfaceProfileSteps::last_step:
          return time == program.final_time();
        case SurfaceProfileSteps::none:
          return false;
      }
    Assert(false, ExcInternalError());
    return false;
  }



  // The contact is looked at where it turns back.
  template <int dim>
  void
  StepEvaluation<dim>::note(const SolveResult &result,
                            const LastStep    &last_step)
  {
    if (last_step.is_largest(result.contact_area) &&
        body.model.load_program.is_segment_end(result.time))
      if (const std::string warning =
            result.contact_area > 0. ?
              body.contact_zone().warning(body.model.indenter.shape->detail()) :
              warning_of_missed_contact();
          !warning.empty())
        log.warn_once(warning);
    imprint.note(result);
  }



  template <int dim>
  std::string
  StepEvaluation<dim>::warning_of_missed_contact() const
  {
    const bool has_entered =
      !body.contact().entries_entered(body.displacement()).empty();
    if (!Utilities::MPI::logical_or(has_entered,
                                    communicator_of(body.dof_handler())))
      return {};
    return "The indenter is in the body, between the nodes that could touch it, "
           "and meets no resistance: the mesh is too coarse under its tip. Set "
           "'Geometry/Local refinements', or take more load steps if the mesh "
           "follows the contact.";
  }



  template <int dim>
  void
  StepEvaluation<dim>::warn_of_depth(const SolveResult &result)
  {
    if (result.contact_area == 0. || !body.contact().is_force_driven())
      return;
    const double height = body_height(body.triangulation());
    if (body.model.boundary_conditions.prescribed_displacements().empty() &&
        result.depth - body.model.indenter.initial_gap >= height)
      log.warn_once(
        "The indenter is through the body, whose height is " + to_text(height) +
        ". Are the force in 'Loading' and the moduli in 'Material' in the same "
        "system of units?");
  }



  template <int dim>
  void
  StepEvaluation<dim>::warn_of_large_strains(const SolveResult &result)
  {
    if (body.model.strain_model.is_finite())
      return;
    if (const std::string warning = small_strain_guard.warning(result);
        !warning.empty())
      log.warn(warning);
  }



  template <int dim>
  void
  StepEvaluation<dim>::warn_of_pressure(const SolveResult &result)
  {
    const double strain = result.max_equivalent_plastic_strain;
    if (!pressure_guard.is_exceeded(result.max_pressure, strain))
      return;
    std::ostringstream text;
    text.precision(4);
    text << "Step " << result.step << ": the contact pressure at ("
         << Patterns::Tools::to_string(
              body.contact_evaluation().place_of_largest_pressure())
         << ") is " << result.max_pressure
         << ", more than a large body with this yield stress can bear ("
         << pressure_guard.limit(strain)
         << " at most). In a thin layer on something rigid that may be; else "
            "the mesh is too coarse for this contact, or locks. See "
            "doc/trust/pressures.md. This is not said again.";
    log.warn(text.str());
  }



  template <int dim>
  void
  StepEvaluation<dim>::warn_of_residual(const SolveResult &result,
                                        const double       tolerance) const
  {
    if (result.residual <= tolerance)
      return;
    std::ostringstream text;
    text << "The forces on the free unknowns are up to "
         << std::pow(10., std::ceil(std::log10(result.residual)))
         << " of all forces, above 'Nonlinear solver/Tolerance': parts of the "
            "body are so stiff, or so nearly incompressible, that the rounding "
            "of the displacements does not allow for less. Column 'residual' "
            "of statistics.csv has them at each step; this is said again only "
            "if they grow tenfold.";
    log.warn_once(text.str());
  }



  template <int dim>
  void
  StepEvaluation<dim>::warn_of_limits(const SolveResult &result)
  {
    warn_of_depth(result);
    warn_of_large_strains(result);
    warn_of_pressure(result);
  }



  template <int dim>
  void
  StepEvaluation<dim>::do_not_repeat(const SolveResult &result)
  {
    small_strain_guard.warning(result);
    pressure_guard.is_exceeded(result.max_pressure,
                               result.max_equivalent_plastic_strain);
  }



  template class StepEvaluation<2>;
  template class StepEvaluation<3>;
} // namespace ElastoPlastic
