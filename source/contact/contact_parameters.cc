// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "contact/contact_parameters.h"

namespace ElastoPlastic
{
  void
  ContactParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Contact");
    prm.add_parameter(
      "Edge",
      edge,
      "Where the contact ends. at nodes: one node after the other comes into "
      "contact; each makes the force jump where the body flows plastically, and "
      "the contact area counts whole nodes. within faces: in a load history its "
      "edge moves through the faces of the mesh, and force and contact area "
      "change smoothly with the depth.");
    prm.add_parameter(
      "Geometry",
      geometry,
      "Where a node meets the indenter. vertical: above its place in the "
      "undeformed body, as in the theory of Johnson; the force is vertical. "
      "normal: above that place, too, but on the tangent plane of the indenter; "
      "the force is along its normal. present: above its present place. "
      "automatic: present with 'Strain = logarithmic'; else vertical if the "
      "contact surface is flat, and normal if it is curved.");
    prm.leave_subsection();
  }
} // namespace ElastoPlastic
