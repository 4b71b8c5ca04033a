// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/body/evaluated_bounds.h"
#include "bounds/mechanism/load_power.h"
#include "bounds/mechanism/sheet_program.h"
#include "bounds/mechanism/stream_program.h"
#include "bounds/mechanism/velocity_check.h"
#include "bounds/mechanism/velocity_program.h"

namespace ElastoPlastic
{
  namespace
  {
    VelocityField
    find_mechanism(const PlaneBody &body)
    {
      try
        {
          return body.kinematics == Kinematics::plane_stress ?
                   find_motion_of_sheet(body) :
                   find_stream(body);
        }
      catch (const UnboundedError &)
        {
          throw ConvergenceError(
            body.load_factor_unit > 0 ?
              "No velocity lets the loads that grow do work: the supports "
              "enclose the body. (Mechanisms that change the volume of a hole "
              "are not looked for.)" :
              "No velocity moves the whole indenter down: it reaches a point "
              "that is held, or the supports enclose the body. Let "
              "'Indenter/Reach' end before what is held. (Mechanisms that "
              "change the volume of a hole are not looked for.)");
        }
    }
  } // namespace



  VelocityField
  minimize_plastic_work(const PlaneBody &body)
  {
    VelocityField field = find_mechanism(body);
    evaluate_mechanism(body, field);
    return field;
  }
} // namespace ElastoPlastic
