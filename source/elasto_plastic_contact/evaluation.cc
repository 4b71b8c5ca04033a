// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "elasto_plastic_contact.h"
#include "evaluation/modelled_part.h"
#include "mechanics/external_forces.h"

namespace ElastoPlastic
{
  // The forces of the supports at the end of the load step under way, in the
  // order of reactions.names().
  template <int dim>
  std::vector<double>
  ElastoPlasticContact<dim>::support_forces() const
  {
    return reactions.compute(*solid, displacement, loads_on_body());
  }



  // All nodal forces but those of the supports; so they must not be condensed
  // with skew rollers.
  template <int dim>
  VectorType
  ElastoPlasticContact<dim>::loads_on_body() const
  {
    VectorType loads;
    solid->initialize_vector(loads);
    compute_external_forces(loads,
                            dof_handler,
                            supports.hanging_nodes(),
                            model.boundary_conditions,
                            model.strain_model.kinematics,
                            time_steps.next_time());
    for (const unsigned int i : contact.active_entries())
      loads.local_element(i) -= residual.local_element(i);
    return loads;
  }



  // In plane strain a depth depends on the size of the body, and so would the
  // evaluation.
  template <int dim>
  std::optional<IndentationTest>
  ElastoPlasticContact<dim>::make_indentation_test() const
  {
    const bool is_plane =
      dim == 2 && model.strain_model.kinematics != Kinematics::axisymmetric;
    if (!gap_function.has_indenter() || is_plane)
      return {};
    const double part = modelled_part(triangulation,
                                      model.boundary_conditions.ids(
                                        BoundaryConditionType::contact),
                                      gap_function.position());
    if (part == 0.)
      return {}; // the indenter's axis does not meet the body
    return IndentationTest(model.indenter.shape,
                           model.indenter.initial_gap,
                           part);
  }



  template class ElastoPlasticContact<2>;
  template class ElastoPlasticContact<3>;
} // namespace ElastoPlastic
