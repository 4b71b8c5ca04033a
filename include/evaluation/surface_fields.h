// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_surface_fields_h
#define evaluation_surface_fields_h

#include <limits>

#include "contact/contact_evaluation.h"
#include "mechanics/ghosted_copy.h"

namespace ElastoPlastic
{
  /// The fields of the contact surface, in the layout of displacements, with
  /// ghost values; all but displacement and shear in the vertical component
  /// only.
  struct SurfaceFields
  {
    VectorType displacement;
    /// To the indenter in its present position; not a number at nodes that it
    /// does not reach.
    VectorType gap;
    VectorType pressure;
    VectorType active;
    /// With friction: the shear traction on the body, and ones at nodes that
    /// stick, zero elsewhere.
    VectorType shear;
    VectorType stick;
    /// Whether the contact is where the deformation has brought the surface, or
    /// where it was.
    bool at_present_place;
  };



  /// Those of the displacement @p u with the forces @p residual.
  /// @p constraints are those of hanging nodes. Collective.
  template <int dim>
  SurfaceFields
  surface_fields(const DoFHandler<dim>           &dof_handler,
                 const AffineConstraints<double> &constraints,
                 const ContactSet<dim>           &contact,
                 const VectorType                &u,
                 const VectorType                &residual)
  {
    VectorType gap(u.get_partitioner()), pressure(gap), active(gap), shear(gap),
      stick(gap);
    gap = std::numeric_limits<double>::quiet_NaN();
    const ContactEvaluation<dim> evaluation(contact, u, residual);
    evaluation.surface_fields(gap, pressure, active);
    if (contact.has_friction())
      evaluation.friction_fields(shear, stick);
    for (VectorType *field : {&pressure, &active, &shear, &stick})
      constraints.distribute(*field);
    return {ghosted_copy(u, dof_handler),
            ghosted_copy(gap, dof_handler),
            ghosted_copy(pressure, dof_handler),
            ghosted_copy(active, dof_handler),
            ghosted_copy(shear, dof_handler),
            ghosted_copy(stick, dof_handler),
            contact.has_curved_bounds()};
  }
} // namespace ElastoPlastic

#endif
