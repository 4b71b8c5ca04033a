// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef problem_load_checks_h
#define problem_load_checks_h

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>

#include "loading/time_steps.h"
#include "output/output_parameters.h"
#include "problem/model.h"

// What can be wrong with loads although each entry is right, and shows when
// time goes on: looked at before there are results and earlier ones are gone.

namespace ElastoPlastic
{
  /// An expression shows what is wrong with it only where and when it is
  /// evaluated: so it is, for the ends of all steps ahead of @p steps, on the
  /// loaded boundaries and, for body forces, in a sample of the cells. And
  /// something must load the body at one of these times, by more than vanishes
  /// in the rounding of its deformation. @p triangulation is that of
  /// @p dof_handler. Collective. @throws InputError
  template <int dim>
  void
  check_loads(const Model<dim>                                &model,
              const TimeSteps                                 &steps,
              const DoFHandler<dim>                           &dof_handler,
              const parallel::distributed::Triangulation<dim> &triangulation);

  /// Each time at which fields are to be written must be within the history.
  /// @throws InputError
  void
  check_field_times(const OutputParameters &output,
                    const LoadProgram      &load_program);
} // namespace ElastoPlastic

#endif
