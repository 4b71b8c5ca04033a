// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef problem_support_checks_h
#define problem_support_checks_h

#include <deal.II/distributed/tria.h>

#include "contact/contact_set.h"
#include "contact/gap_function.h"
#include "input/limit_load_parameters.h"
#include "loads/supports.h"
#include "problem/model.h"
#include "solver/tangent_operator.h"

// Whether the supports hold the body, looked at before there are results and
// earlier ones are gone.

namespace ElastoPlastic
{
  /// The supports must prevent every rigid body motion of every part. The
  /// indenter, free of friction and adhesion, helps them only where it is kept
  /// in its place and the tractions press the body against it. Collective.
  /// @throws InputError
  template <int dim>
  void
  check_supports(const Model<dim>      &model,
                 const DoFHandler<dim> &dof_handler,
                 const Supports<dim>   &supports,
                 const ContactSet<dim> &contact,
                 const VectorType      &external_forces);

  /// Of a rigid-plastic body under limit loads, the supports must prevent those
  /// rigid body motions that the loads drive: the indenter, if it is its force
  /// that grows, because all that it reaches would move down; tractions and
  /// body forces by their power, unless an indenter might hold the body, which
  /// is not decided here. Collective. @throws InputError
  template <int dim>
  void
  check_supports_of_limit_load(
    const Model<dim>                                &model,
    const GrowingLoad                                growing_load,
    const GapFunction<dim>                          &gap_function,
    const parallel::distributed::Triangulation<dim> &triangulation);
} // namespace ElastoPlastic

#endif
