// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <string>

#include "bounds/body/evaluated_bounds.h"
#include "bounds/mechanism/velocity_check.h"
#include "bounds/mechanism/velocity_program.h"

namespace ElastoPlastic
{
  namespace
  {
    VelocityField<2>
    find_mechanism(const SplitBody<2> &body, const double tolerance)
    {
      return body.can_slide() ? find_stream(body, tolerance) :
                                find_motion_of_sheet(body, tolerance);
    }

    VelocityField<3>
    find_mechanism(const SplitBody<3> &body, const double tolerance)
    {
      return body.can_slide() ? find_flux(body, tolerance) :
                                find_motion_of_sheet(body, tolerance);
    }
  } // namespace



  template <int dim>
  VelocityField<dim>
  minimize_plastic_work(const SplitBody<dim> &body, const double tolerance)
  {
    try
      {
        VelocityField<dim> field = find_mechanism(body, tolerance);
        evaluate_mechanism(body, field);
        return field;
      }
    catch (const UnboundedError &)
      {
        throw ConvergenceError(
          std::string(
            body.load_factor_unit > 0 ?
              "No velocity lets the loads that grow do work: the supports "
              "enclose the body." :
              "No velocity moves the whole indenter down: it reaches a point "
              "that is held, or the supports enclose the body. Let "
              "'Indenter/Reach' end before what is held.") +
          (dim == 2 ? " (Mechanisms that change the volume of a hole are not "
                      "looked for.)" :
                      ""));
      }
  }



  template VelocityField<2>
  minimize_plastic_work(const SplitBody<2> &, const double);
  template VelocityField<3>
  minimize_plastic_work(const SplitBody<3> &, const double);
} // namespace ElastoPlastic
