// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_sample_model_h
#define tests_sample_model_h

#include "material/material_parameters.h"
#include "problem/model.h"

namespace ElastoPlastic
{
  /// The model of a body that a test meshes by itself: only its boundary
  /// conditions, its strains and the default material mean anything.
  template <int dim>
  Model<dim>
  sample_model(const BoundaryConditions<dim> &conditions,
               const StrainModel             &strain_model =
                 StrainModel(VolumetricTreatment::standard))
  {
    return {{conditions, BodyForce<dim>(), strain_model},
            Geometry<dim>(GeometryParameters()),
            /* degree = */ 1,
            MaterialParameters().materials(),
            PlacedIndenter<dim>(),
            ContactParameters(),
            LoadProgram(LoadingParameters())};
  }
} // namespace ElastoPlastic

#endif
