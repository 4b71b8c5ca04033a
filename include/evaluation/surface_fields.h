// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_surface_fields_h
#define evaluation_surface_fields_h

#include <limits>

#include "contact/contact_set.h"
#include "mechanics/ghosted_copy.h"

namespace ElastoPlastic
{
  /// The fields of the contact surface, in the layout of displacements, with
  /// ghost values; all but the displacement in the vertical component only.
  struct SurfaceFields
  {
    VectorType displacement;
    /// To the indenter in its present position; not a number at nodes that it
    /// does not reach.
    VectorType gap;
    VectorType pressure;
    VectorType active;
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
    VectorType gap(u.get_partitioner()), pressure(gap), active(gap);
    gap = std::numeric_limits<double>::quiet_NaN();
    contact.surface_fields(gap, pressure, active, u, residual);
    constraints.distribute(pressure);
    constraints.distribute(active);
    return {ghosted_copy(u, dof_handler),
            ghosted_copy(gap, dof_handler),
            ghosted_copy(pressure, dof_handler),
            ghosted_copy(active, dof_handler),
            contact.has_curved_bounds()};
  }
} // namespace ElastoPlastic

#endif
