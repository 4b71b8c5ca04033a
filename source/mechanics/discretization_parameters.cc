// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "mechanics/discretization_parameters.h"

namespace ElastoPlastic
{
  void
  DiscretizationParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Kinematics",
      kinematics,
      "What a body in two dimensions is. plane strain: the "
      "section of a long body; forces are per unit of "
      "thickness. plane stress: a thin sheet of unit "
      "thickness that bears no stress across; with 'Volumetric "
      "treatment = standard', it does not lock. axisymmetric: the half section x >= 0 of an "
      "axisymmetric body, y is its axis; forces and areas are "
      "those of the whole body.");
    prm.add_parameter(
      "Strain",
      strain,
      "small: as in the theory of Johnson, with the vertical gap of the "
      "undeformed surface. logarithmic: deformations of any size, with the "
      "indenter met where the surface is then; what sharp tips need, and "
      "spheres that are pressed in deeper than contact radius / radius = 0.25.");
    prm.enter_subsection("Discretization");
    prm.add_parameter("Polynomial degree",
                      degree,
                      "The degree p of the displacement elements FE_Q(p): 1 or "
                      "2. Quadratic elements do not lock and are the more "
                      "accurate ones per unknown.",
                      Patterns::Integer(1, 2));
    prm.add_parameter(
      "Volumetric treatment",
      volumetric_treatment,
      "standard: full integration; linear elements then lock as soon as plastic "
      "flow dominates and show no limit load. B-bar: the volume change enters "
      "by its mean over each cell, which does not lock.");
    prm.leave_subsection();
  }
} // namespace ElastoPlastic
