// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "indenter/indenter_library.h"
#include "problem/make_model.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Bounds of errors are those with the vertical gap. A single step is the
    /// stationary problem of Johnson, whose contact ends at nodes.
    ContactParameters
    contact_of(const Parameters &parameters)
    {
      ContactParameters result = parameters.contact;
      if (parameters.analysis == Analysis::contact_with_error_bound &&
          result.geometry == ContactGeometry::automatic)
        result.geometry = ContactGeometry::vertical;
      if (parameters.loading.is_single_step() &&
          result.edge == EdgeRule::within_faces)
        result.edge = EdgeRule::measured_within_faces;
      return result;
    }
  } // namespace



  template <int dim>
  Model<dim>
  make_model(const Parameters &parameters)
  {
    const Geometry<dim> geometry(parameters.geometry);
    return {{BoundaryConditions<dim>(parameters.boundary_conditions,
                                     geometry.boundary_names()),
             BodyForce<dim>(parameters.body_force.components),
             parameters.discretization.strain_model()},
            geometry,
            parameters.discretization.degree,
            parameters.material.materials(),
            make_indenter<dim>(parameters.indenter),
            contact_of(parameters),
            LoadProgram(parameters.loading)};
  }



  template Model<2>
  make_model(const Parameters &);
  template Model<3>
  make_model(const Parameters &);
} // namespace ElastoPlastic
