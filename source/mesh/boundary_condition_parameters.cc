// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include "base/exceptions.h"
#include "mesh/boundary_condition_parameters.h"

namespace ElastoPlastic
{
  void
  BoundaryConditionParameters::add_parameters(ParameterHandler &prm)
  {
    const std::string    example = ", for instance: bottom, left.";
    const Patterns::List names{Patterns::Anything()};
    const std::string    in_components =
      "Boundaries are separated by '|', the name from its components by ':', "
      "the components, one per dimension, by ';'. Each is an expression in x, "
      "y (, z) and the time t; conditions are written if(t < 1, t, 1), and '|' "
      "cannot be used in them";

    prm.enter_subsection("Boundary conditions");
    prm.add_parameter("Fixed",
                      fixed,
                      "Boundaries where the displacement is zero" + example,
                      names);
    prm.add_parameter(
      "Roller",
      roller,
      "Boundaries that slide along their own surface without friction (normal "
      "displacement and tangential traction are zero), like planes of "
      "symmetry" +
        example,
      names);
    prm.add_parameter("Free",
                      free,
                      "Boundaries without traction" + example,
                      names);
    prm.add_parameter(
      "Contact",
      contact,
      "Boundaries that the indenter can touch, without traction where it does "
      "not. They should be level, facing upwards" +
        example,
      names);
    prm.add_parameter(
      "Prescribed displacement",
      prescribed_displacement,
      "Boundaries with a given displacement. " + in_components +
        "; the word free leaves a component free. For instance: "
        "right: 0.01*t; free | left: 0; free. Unit: length.",
      Patterns::Anything());
    prm.add_parameter("Traction",
                      traction,
                      "Boundaries that carry a given traction. " +
                        in_components +
                        ". For instance: right: 100*t; 0. Unit: stress.",
                      Patterns::Anything());
    prm.leave_subsection();
  }
} // namespace ElastoPlastic
