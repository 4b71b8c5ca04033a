// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_contact_parameters_h
#define contact_contact_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>

#include "contact/contact_geometry.h"
#include "contact/edge_law.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Contact".
  struct ContactParameters
  {
    EdgeRule        edge     = EdgeRule::within_faces;
    ContactGeometry geometry = ContactGeometry::automatic;
    std::string     friction = "0";

    /// Coulomb's coefficient; infinite for nodes that stick.
    /// @throws InputError
    double
    friction_coefficient() const;

    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace ElastoPlastic

#endif
