// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_nominal_contact_h
#define evaluation_nominal_contact_h

#include <deal.II/distributed/tria.h>

#include <memory>
#include <optional>
#include <set>

#include "contact/contact_state.h"
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



  /// The contact of an indenter with a single tip, taken as a circle about its
  /// axis with the area of the contact; in plane problems, a strip. It knows
  /// which part of that is modelled, which all who evaluate the contact ask it.
  template <int dim>
  class NominalContact
  {
  public:
    /// Collective.
    NominalContact(
      const LoadedBody<dim>                           &body,
      const PlacedIndenter<dim>                       &indenter,
      const parallel::distributed::Triangulation<dim> &triangulation,
      const GapFunction<dim>                          &gap_function);

    /// Whether the problem is plane strain or plane stress.
    bool
    is_strip() const
    {
      return in_plane;
    }

    /// Whether the contact is certainly a single one: the indenter is convex.
    bool
    is_single() const
    {
      return shape && shape->is_convex();
    }

    /// How much of the surroundings of the axis is modelled; see
    /// modelled_part(). 0 if the axis does not meet the body.
    double
    part_of_surroundings() const
    {
      return part;
    }

    /// The radius of the circle, or half the width of the strip, if the
    /// modelled part of the contact has this @p area. (An axis beside the body
    /// tells nothing: then that is the whole contact.)
    double
    radius(const double area) const
    {
      return contact_radius(area, part == 0. ? 1. : part, in_plane);
    }

    /// How deep the tip is below the undeformed surface at this @p depth of the
    /// indenter.
    double
    depth_of_tip(const double depth) const
    {
      return depth - initial_gap;
    }

    /// The radius of the indenter where it cuts the undeformed surface at this
    /// @p depth; none if it is not there yet, or if there is no single tip.
    std::optional<double>
    radius_at_surface(const double depth) const;

    /// How steep the indenter is at this @p radius; none where it is flat or
    /// ends.
    std::optional<double>
    slope(const double radius) const;

  private:
    const std::shared_ptr<const Indenter<dim>> shape;
    const double                               initial_gap;
    const bool                                 in_plane;
    const double                               part;
  };



  /// What a test in a laboratory would evaluate of a @p contact; nothing
  /// without an indenter, where its axis does not meet the body, and in plane
  /// problems, where a depth depends on the size of the body. Collective.
  template <int dim>
  std::optional<IndentationTest>
  make_indentation_test(
    const NominalContact<dim>                       &contact,
    const LoadedBody<dim>                           &body,
    const PlacedIndenter<dim>                       &indenter,
    const parallel::distributed::Triangulation<dim> &triangulation,
    const GapFunction<dim>                          &gap_function,
    const EvaluationParameters                      &constants);
} // namespace ElastoPlastic

#endif
