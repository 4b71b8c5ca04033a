// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_surface_fields_h
#define evaluation_surface_fields_h

#include <limits>

#include "base/ghost_values.h"
#include "contact/contact_evaluation.h"
#include "mechanics/solid_operator.h"

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
    /// With friction, else empty: the shear traction on the body, and ones at
    /// nodes that stick, zero elsewhere.
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
    const ContactEvaluation<dim> evaluation(contact, u, residual);
    const auto                   layout = u.get_partitioner();

    SurfaceFields fields;
    fields.at_present_place = contact.has_curved_bounds();
    for (VectorType *field : {&fields.gap, &fields.pressure, &fields.active})
      field->reinit(layout);
    fields.gap = std::numeric_limits<double>::quiet_NaN();
    evaluation.surface_fields(fields.gap, fields.pressure, fields.active);
    if (contact.has_friction())
      {
        fields.shear.reinit(layout);
        fields.stick.reinit(layout);
        evaluation.friction_fields(fields.shear, fields.stick);
      }
    for (VectorType *field :
         {&fields.pressure, &fields.active, &fields.shear, &fields.stick})
      if (field->size() > 0)
        constraints.distribute(*field);
    fields.displacement = u;
    for (VectorType *field : {&fields.displacement,
                              &fields.gap,
                              &fields.pressure,
                              &fields.active,
                              &fields.shear,
                              &fields.stick})
      if (field->size() > 0)
        replace_by_ghosted_copy(*field, dof_handler);
    return fields;
  }
} // namespace ElastoPlastic

#endif
