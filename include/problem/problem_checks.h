// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef problem_problem_checks_h
#define problem_problem_checks_h

#include "loading/time_steps.h"
#include "problem/model.h"

// What can be wrong with a problem although each of its entries is right, and
// shows on a mesh: looked at before there are results and earlier ones are
// gone.

namespace ElastoPlastic
{
  /// The indenter comes from above: each contact boundary must have a face that
  /// faces upwards. Collective. @throws InputError
  template <int dim>
  void
  check_contact_boundaries(
    const Model<dim>                                &model,
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

  /// Of the size of the body, an indenter that ends must have a part that a
  /// mesh can resolve. Collective. @throws InputError
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
} // namespace ElastoPlastic

#endif
