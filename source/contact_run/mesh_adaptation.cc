// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "contact_run/mesh_adaptation.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Relative: rounding and the tolerance of Newton's method change the
    /// errors of cells by less.
    constexpr double accuracy_of_indicators = 1e-5;
  } // namespace



  template <int dim>
  MeshAdaptation<dim>::MeshAdaptation(const RefinementParameters &parameters,
                                      DiscreteBody<dim>          &body,
                                      Log                        &log)
    : parameters(parameters)
    , body(body)
    , log(log)
    , finest_first_level(body.triangulation().n_global_levels() - 1)
  {
    parameters.check_first_mesh(
      estimated_unknowns(body.triangulation().n_global_active_cells(),
                         body.fe));
  }



  template <int dim>
  double
  MeshAdaptation<dim>::min_gap() const
  {
    const double of_candidates = body.contact().min_gap();
    return parameters.n_over_contact_radius > 0 ?
             std::min(of_candidates, body.contact().min_gap_without_area()) :
             of_candidates;
  }



  // In cycles, and until the elements are small enough for the contact. (Not
  // with finite strains: a step, however short, would press many virgin
  // elements of such a mesh at once. There, refinement follows from step to
  // step.)
  template <int dim>
  bool
  MeshAdaptation<dim>::mark_in_step(const unsigned int step,
                                    const unsigned int cycle)
  {
    if (step > 1)
      return false;
    clear_flags(body.cells_to_flag());
    const bool is_next_cycle = cycle + 1 < parameters.n_cycles;
    if (is_next_cycle)
      flag_cells(parameters,
                 body.error_indicators(),
                 accuracy_of_indicators,
                 body.cells_to_flag());
    const bool follows_contact =
      !body.model.strain_model.is_finite() && mark_contact_zone(step);
    if (follows_contact)
      return may_follow_contact(step);
    if (!is_next_cycle)
      return false;
    if (next_mesh_is_allowed())
      return true;
    log.remark(
      "The next mesh would have more unknowns than "
      "'Refinement/Maximum number of unknowns' allows.");
    return false;
  }



  // As it unloads, the contact stays on the mesh that its largest area has
  // asked for; the stiffness of an unloading is that of one mesh. It moves
  // sideways over a mesh that keeps what it has left behind.
  template <int dim>
  bool
  MeshAdaptation<dim>::mark_after(const LastStep &last_step)
  {
    const LoadProgram &program = body.model.load_program;
    const SolveResult &result  = last_step.result;
    const bool         by_errors =
      is_due(result.step) &&
      flag_cells_within(static_cast<double>(body.dof_handler().n_dofs()) /
                          body.triangulation().n_global_active_cells(),
                        parameters,
                        body.error_indicators(),
                        accuracy_of_indicators,
                        body.cells_to_flag());
    if (!by_errors)
      clear_flags(body.cells_to_flag());
    const bool grows =
      last_step.is_largest(result.contact_area) || !program.path().is_at_rest();
    const bool outgrows_mesh =
      (enters_untouched(last_step) ||
       (grows && !program.is_segment_end(result.time))) &&
      mark_contact_zone(result.step);
    return outgrows_mesh ? may_follow_contact(result.step) : by_errors;
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::mark_until_touched(const LastStep &last_step)
  {
    clear_flags(body.cells_to_flag());
    return enters_untouched(last_step) &&
           mark_contact_zone(last_step.result.step) &&
           may_follow_contact(last_step.result.step);
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::is_due(const unsigned int step) const
  {
    const unsigned int interval = parameters.adaptation_interval;
    return interval > 0 && step % interval == 0;
  }



  // Around the contact, as it is and as it will be soon: when some cells are
  // too large, others are refined at the same time, so that the next steps can
  // do with that mesh. Cells of the first mesh stay. Where the errors of the
  // solution decide, too, they do not coarsen that zone; nor does an indenter
  // that moves sideways coarsen its groove.
  template <int dim>
  bool
  MeshAdaptation<dim>::mark_contact_zone(const unsigned int step)
  {
    const unsigned int n_over_radius = parameters.n_over_contact_radius;
    if (n_over_radius == 0)
      return false;
    const ContactZone<dim> zone        = body.contact_zone();
    const auto             sizes_after = [&](const double growth) {
      return [&zone, n_over_radius, growth](const Point<dim> &x,
                                            const double      reach) {
        return zone.element_size(x, reach, n_over_radius, growth);
      };
    };
    const bool coarsens = parameters.strategy == RefinementStrategy::none &&
                          body.model.load_program.path().is_at_rest();
    return (is_due(step) ||
            has_larger_cells<dim>(sizes_after(0.05), body.triangulation())) &&
           flag_larger_cells<dim>(sizes_after(0.2),
                                  coarsens ?
                                    std::make_optional(finest_first_level) :
                                    std::nullopt,
                                  body.cells_to_flag());
  }



  // What the next mesh would need is known only when it is there, when there is
  // no way back; but a new cell hardly ever brings fewer unknowns than it has
  // in the interior of a mesh.
  template <int dim>
  bool
  MeshAdaptation<dim>::next_mesh_is_allowed() const
  {
    const double n_new_cells =
      n_cells_after_refinement(body.triangulation()) -
      static_cast<double>(body.triangulation().n_global_active_cells());
    return parameters.allows(body.dof_handler().n_dofs() +
                             estimated_unknowns(n_new_cells, body.fe));
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::may_follow_contact(const unsigned int step)
  {
    if (next_mesh_is_allowed())
      return true;
    if (!has_stopped_following)
      log.warn(
        "From step " + std::to_string(step) +
        " on, the mesh does not follow the contact: the next one would "
        "have more unknowns than 'Refinement/Maximum number of unknowns' "
        "allows, and there will be fewer than the " +
        std::to_string(parameters.n_over_contact_radius) +
        " elements of 'Refinement/Elements over contact radius'. Raise "
        "the one or reduce the other.");
    has_stopped_following = true;
    return false;
  }



  template class MeshAdaptation<2>;
  template class MeshAdaptation<3>;
} // namespace ElastoPlastic
