// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef problem_problem_checks_h
#define problem_problem_checks_h

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>

#include "contact/contact_set.h"
#include "contact/gap_function.h"
#include "input/limit_load_parameters.h"
#include "loading/time_steps.h"
#include "loads/supports.h"
#include "output/output_parameters.h"
#include "problem/model.h"
#include "solver/tangent_operator.h"

// What can be wrong with a problem although each of its entries is right, and
// shows on a mesh or when time goes on: looked at before there are results and
// earlier ones are gone. The checks of loads are in load_checks.cc, those of
// supports in support_checks.cc, those of planes of symmetry in
// symmetry_checks.cc.

namespace ElastoPlastic
{
  /// The indenter comes from above: each contact boundary must have a face that
  /// faces upwards. Collective. @throws InputError
  template <int dim>
  void
  check_contact_boundaries(
    const Model<dim>                                &model,
    const parallel::distributed::Triangulation<dim> &triangulation);

  /// Rollers in a vertical plane through the first position of the indenter
  /// make that a plane of symmetry: of the yield criteria of the materials,
  /// too, in a plane body or in space. Collective. @throws InputError
  template <int dim>
  void
  check_symmetry_of_materials(
    const Model<dim>                                &model,
    const parallel::distributed::Triangulation<dim> &triangulation);

  /// The same of the shape of the indenter, where it has been put. Collective.
  /// @throws InputError
  template <int dim>
  void
  check_symmetry_of_indenter(
    const Model<dim>                                &model,
    const GapFunction<dim>                          &gap_function,
    const parallel::distributed::Triangulation<dim> &triangulation);

  /// The indenter must be able to touch the body, and the load program must
  /// let it press beyond the smallest gap under it, which is @p min_gap, or up
  /// to it if other loads may press the body against it. @throws InputError
  template <int dim>
  void
  check_reach(const Model<dim>        &model,
              TimeSteps                steps,
              const LoadingParameters &loading,
              const double             min_gap);

  /// The face of an indenter that ends must be a part of the size of the body
  /// that a mesh can resolve. Collective. @throws InputError
  template <int dim>
  void
  check_width(const GapFunction<dim>                          &gap_function,
              const parallel::distributed::Triangulation<dim> &triangulation);

  /// The prescribed depth must be smaller than the body is high, unless the
  /// body moves, too. Collective. @throws InputError
  template <int dim>
  void
  check_depth(const Model<dim>         &model,
              const TimeSteps          &steps,
              const LoadingParameters  &loading,
              const Triangulation<dim> &triangulation);

  /// An indenter that stands on planes of symmetry, which are rollers through
  /// its first position, must stay on them. As much of the contact boundary as
  /// surrounds its tip there must do so everywhere: it does not come to an
  /// edge, nor does the foremost point of its contact, as far as that is known
  /// (NominalContact). Its path must be known at the ends of all steps ahead of
  /// @p steps. Collective. @throws InputError
  template <int dim>
  void
  check_path(const Model<dim>                                &model,
             const GapFunction<dim>                          &gap_function,
             TimeSteps                                        steps,
             const LoadingParameters                         &loading,
             const parallel::distributed::Triangulation<dim> &triangulation);



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

  /// The supports of a rigid-plastic body under limit loads must prevent those
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
