// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_nominal_contact_h
#define evaluation_nominal_contact_h

#include <deal.II/distributed/tria.h>

#include <memory>
#include <optional>

#include "contact/gap_function.h"
#include "loads/loaded_body.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The contact of an indenter with a single tip, taken as a circle about its
  /// axis with the area of the contact; in plane problems, a strip.
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
    is_strip() const;

    /// Whether the contact is certainly a single one: the indenter is convex.
    bool
    is_single() const;

    /// The radius of the circle, or half the width of the strip, if the
    /// modelled part of the contact has this @p area.
    double
    radius(const double area) const;

    /// How deep the tip is below the undeformed surface at this @p depth of the
    /// indenter.
    double
    depth_of_tip(const double depth) const;

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
    /// How much of the surroundings of the tip is modelled.
    const double part;
  };
} // namespace ElastoPlastic

#endif
