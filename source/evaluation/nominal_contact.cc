// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "evaluation/modelled_part.h"
#include "evaluation/nominal_contact.h"

namespace ElastoPlastic
{
  template <int dim>
  NominalContact<dim>::NominalContact(
    const LoadedBody<dim>                           &body,
    const PlacedIndenter<dim>                       &indenter,
    const parallel::distributed::Triangulation<dim> &triangulation,
    const GapFunction<dim>                          &gap_function)
    : shape(indenter.shape)
    , initial_gap(indenter.initial_gap)
    , in_plane(is_plane_problem<dim>(body.strain_model.kinematics))
    , part(modelled_part(triangulation,
                         body.boundary_conditions.ids(
                           BoundaryConditionType::contact),
                         gap_function.position(),
                         body.strain_model.kinematics))
  {}



  template <int dim>
  bool
  NominalContact<dim>::is_strip() const
  {
    return in_plane;
  }



  template <int dim>
  bool
  NominalContact<dim>::is_single() const
  {
    return shape && shape->is_convex();
  }



  template <int dim>
  double
  NominalContact<dim>::radius(const double area) const
  {
    return part == 0. ? 0. : contact_radius(area, part, in_plane);
  }



  template <int dim>
  double
  NominalContact<dim>::depth_of_tip(const double depth) const
  {
    return depth - initial_gap;
  }



  template <int dim>
  std::optional<double>
  NominalContact<dim>::radius_at_surface(const double depth) const
  {
    if (!shape || part == 0. || !(depth_of_tip(depth) > 0.))
      return {};
    const double area = shape->section_area(depth_of_tip(depth));
    if (area == 0.)
      return {};
    return std::sqrt(area / numbers::PI);
  }



  // A difference that is as good as the derivative: of a sphere, it is too
  // small by a thousandth.
  template <int dim>
  std::optional<double>
  NominalContact<dim>::slope(const double radius) const
  {
    const double   step = 2e-3 * radius;
    Point<dim - 1> outside, inside;
    outside[0]        = radius;
    inside[0]         = radius - step;
    const double rise = shape->profile(outside) - shape->profile(inside);
    if (!std::isfinite(rise) || !(rise > 0.))
      return {};
    return rise / step;
  }



  template class NominalContact<2>;
  template class NominalContact<3>;
} // namespace ElastoPlastic
