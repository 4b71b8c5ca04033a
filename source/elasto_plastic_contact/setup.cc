// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/dofs/dof_tools.h>

#include <sstream>

#include "base/exceptions.h"
#include "base/rethrow_collectively.h"
#include "elasto_plastic_contact.h"
#include "make_tangent_solver.h"
#include "mechanics/boundary_points.h"
#include "mechanics/rigid_body_modes.h"

namespace ElastoPlastic
{
  // Everything that depends on the mesh is prepared in the next two functions
  // and nowhere else. First unknowns, supports and the body; the displacement
  // is zero afterwards, unless refine_mesh() puts a better guess there.
  template <int dim>
  void
  ElastoPlasticContact<dim>::setup_body()
  {
    TimerOutput::Scope scope(timer, "Setup");

    dof_handler.distribute_dofs(fe);
    supports.reinit(dof_handler,
                    model.boundary_conditions,
                    time_steps.next_time());
    solid->reinit(dof_handler, supports.constraints());
    solid->initialize_vector(displacement);
  }



  // Then external forces, contact candidates and the linear solver.
  template <int dim>
  void
  ElastoPlasticContact<dim>::setup_contact()
  {
    TimerOutput::Scope scope(timer, "Setup");

    solid->initialize_vector(residual);
    solid->initialize_vector(external_forces);
    contact.reinit(dof_handler,
                   supports.constraints(),
                   model.boundary_conditions.ids(
                     BoundaryConditionType::contact),
                   supports.fixed_dofs(),
                   residual);
    apply_load();

    tangent_solver = make_tangent_solver(parameters.linear_solver,
                                         *solid,
                                         dof_handler,
                                         supports.constraints(),
                                         model.boundary_conditions,
                                         model.strain_model,
                                         residual,
                                         [this](const std::string &warning) {
                                           log.warn(warning);
                                         });
    error_indicators.reinit(triangulation.n_active_cells());
  }



  // An expression shows what is wrong with it only where and when it is
  // evaluated: so it is, for the ends of all steps, before there are results
  // and earlier ones are gone.
  template <int dim>
  void
  ElastoPlasticContact<dim>::check_loads() const
  {
    std::set<types::boundary_id> boundaries =
      model.boundary_conditions.ids(BoundaryConditionType::traction);
    boundaries.merge(model.boundary_conditions.ids(
      BoundaryConditionType::prescribed_displacement));
    const auto points = boundary_points(dof_handler, boundaries);

    rethrow_collectively(communicator, [&]() {
      for (TimeSteps step = time_steps; !step.finished(); step.advance())
        {
          load_program.load(step.next_time());
          for (const auto &[boundary, point] : points)
            model.boundary_conditions.check_values(boundary,
                                                   point,
                                                   step.next_time());
        }
    });
  }



  // The supports must prevent every rigid body motion. The indenter, free of
  // friction and adhesion, helps them only where it is kept in its place and
  // the tractions press the body against it.
  template <int dim>
  void
  ElastoPlasticContact<dim>::check_supports() const
  {
    VectorType held;
    solid->initialize_vector(held);
    supports.set_fixed_entries(held, 1.);
    if (model.strain_model.kinematics == Kinematics::axisymmetric)
      for (const auto dof : DoFTools::extract_dofs(
             dof_handler, ComponentMask(std::vector<bool>{true, false})))
        held(dof) = 1.; // rings resist all but the vertical motion

    auto motion = find_free_motion(dof_handler, held, supports.constraints());
    if (motion && is_pressed_against_indenter(motion->displacement))
      {
        contact.set_candidate_entries(held, 1.);
        motion = find_free_motion(dof_handler, held, supports.constraints());
      }
    if (!motion)
      return;

    std::ostringstream what;
    what << "its rigid body motion '" << motion->name << "'";
    if (!motion->whole_body)
      what << " of the part between ("
           << motion->part.get_boundary_points().first << ") and ("
           << motion->part.get_boundary_points().second
           << "), which no face of a cell connects with the rest";
    throw InputError(
      "The supports do not hold the body: nothing prevents " + what.str() +
      ". Add a fixed boundary or rollers to 'Boundary conditions'. The indenter "
      "is no support: it only presses.");
  }



  template <int dim>
  bool
  ElastoPlasticContact<dim>::is_pressed_against_indenter(
    const VectorType &motion) const
  {
    if (contact.is_force_driven())
      return false;
    VectorType candidates;
    solid->initialize_vector(candidates);
    contact.set_candidate_entries(candidates, 1.);
    return (candidates * motion) * (external_forces * motion) > 0;
  }



  template <int dim>
  void
  ElastoPlasticContact<dim>::check_reach() const
  {
    if (!gap_function.has_indenter())
      return;

    if (contact.n_candidates() == 0)
      throw InputError(
        "The indenter can never touch the body: no node of the contact "
        "boundary lies within its reach. Check 'Indenter/Position', its size "
        "and 'Indenter/Reach', or refine the mesh ('Geometry/Initial "
        "refinements').");

    const double min_gap = contact.min_gap();
    bool         touches = false;
    for (TimeSteps step = time_steps; !step.finished(); step.advance())
      {
        const auto load = load_program.load(step.next_time());
        touches =
          touches ||
          (load && (load->control == Control::force || load->value > min_gap));
      }
    const auto &loading = parameters.loading;
    if (!touches)
      throw InputError(
        loading.history.empty() ? "Loading/Depth" : "Loading/History",
        loading.history.empty() ? loading.depth : loading.history,
        "the indenter can never touch the body: the smallest gap "
        "under it is " +
          Patterns::Tools::to_string(min_gap) +
          ". Push deeper, reduce 'Indenter/Initial gap', or "
          "refine the mesh under the tip.");
  }



  // As many as a new cell has in the interior of a mesh.
  template <int dim>
  double
  ElastoPlasticContact<dim>::estimated_unknowns(const double n_cells) const
  {
    return dim * std::pow(fe.degree, dim) * n_cells;
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
