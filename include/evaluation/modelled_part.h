// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_modelled_part_h
#define evaluation_modelled_part_h

#include <deal.II/distributed/tria.h>

#include <optional>
#include <set>

#include "contact/gap_function.h"
#include "evaluation/indentation_test.h"
#include "loads/loaded_body.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// How much of the surroundings of the horizontal @p position belongs to the
  /// boundaries @p contact_boundaries, seen from above, between 0 and 1: 1/4 if
  /// a quarter of a body is modelled that has two planes of symmetry through
  /// the indenter's axis; 1/2 of a plane body with a line of symmetry there. In
  /// an axisymmetric body, where the indenter presses on whole rings, it is 1.
  /// Collective.
  template <int dim>
  double
  modelled_part(const parallel::distributed::Triangulation<dim> &triangulation,
                const std::set<types::boundary_id> &contact_boundaries,
                const Point<dim - 1>               &position,
                const Kinematics                    kinematics);

  /// What a test in a laboratory would evaluate; nothing without an indenter,
  /// where its axis does not meet the body, and in plane strain, where a depth
  /// depends on the size of the body. Collective.
  template <int dim>
  std::optional<IndentationTest>
  make_indentation_test(
    const LoadedBody<dim>                           &body,
    const PlacedIndenter<dim>                       &indenter,
    const parallel::distributed::Triangulation<dim> &triangulation,
    const GapFunction<dim>                          &gap_function,
    const EvaluationParameters                      &constants);
} // namespace ElastoPlastic

#endif
