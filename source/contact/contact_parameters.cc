// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "base/text.h"
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
      "contact; each makes the force jump where the body flows plastically, "
      "and the contact area counts whole nodes. within faces: in a load "
      "history its edge moves through the faces of the mesh, and force and "
      "contact area change smoothly with the depth. A node bears a part of the "
      "pressure of its inner neighbours before it touches, and these may be "
      "inside the indenter by a part of what it rises by between nodes, so "
      "that the force is a little low on coarse meshes. A single step, without "
      "'History' and 'Path', is at nodes in any case.");
    prm.add_parameter(
      "Geometry",
      geometry,
      "Where a node meets the indenter. vertical: above its place in the "
      "undeformed body, as in the theory of Johnson; the force is vertical. "
      "normal: above that place, too, but on the tangent plane of the indenter; "
      "the force is along its normal. present: above its present place. "
      "automatic: present with 'Strain = logarithmic'; else vertical if the "
      "contact surface is flat, and normal if it is curved. For limit loads in "
      "plane strain and of bodies of revolution, normal is across the surface of "
      "the body, and automatic is normal where the indenter fits the surface.");
    prm.add_parameter(
      "Friction coefficient",
      friction,
      "mu of Coulomb's law: where the surface of the body slips along the "
      "indenter, its shear traction is mu times the pressure; where it is less, "
      "the body sticks to the indenter. 0: no friction. stick: the body does "
      "not slip at all as long as it is in contact; what comes into contact in a "
      "load step has moved freely before, so that it takes several.",
      Patterns::Anything());
    prm.leave_subsection();
  }



  double
  ContactParameters::friction_coefficient() const
  {
    if (friction == "stick")
      return std::numeric_limits<double>::infinity();
    const auto number = as_number(friction);
    if (!number || !std::isfinite(*number) || *number < 0)
      throw InputError("Contact/Friction coefficient",
                       friction,
                       "it must be a number, at least 0, or 'stick'.");
    return *number;
  }
} // namespace ElastoPlastic
