// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <cmath>

#include "base/compatibility.h"
#include "evaluation/nominal_contact.h"
#include "evaluation/tip_on_curved_surface.h"
#include "mesh/body_size.h"
#include "mesh/boundary_faces.h"
#include "mesh/disc.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The angle under which a quadrilateral is seen from the origin: 2 pi from
    /// within, 0 from outside, pi from an edge, the corner's angle from there.
    double
    angle_of_view(const std::array<Tensor<1, 2>, 4> &corners)
    {
      double angle = 0;
      for (unsigned int i = 0; i < 4; ++i)
        {
          const auto  &a     = corners[i];
          const auto  &b     = corners[(i + 1) % 4];
          const double cross = a[0] * b[1] - a[1] * b[0];
          if (std::abs(cross) > 1e-10 * (b - a).norm_square())
            angle += std::atan2(cross, a * b);
        }
      return std::abs(angle);
    }
  } // namespace



  template <>
  double
  modelled_part(const parallel::distributed::Triangulation<2> &triangulation,
                const std::set<types::boundary_id> &contact_boundaries,
                const Point<1>                     &position,
                const Kinematics                    kinematics)
  {
    if (kinematics == Kinematics::axisymmetric)
      return 1.;
    double n_sides = 0;
    for (const auto &[cell, f] : owned_faces(triangulation, contact_boundaries))
      {
        const double a         = cell->face(f)->vertex(0)[0] - position[0];
        const double b         = cell->face(f)->vertex(1)[0] - position[0];
        const double tolerance = 1e-10 * std::abs(b - a);
        if (std::min(a, b) < -tolerance && std::max(a, b) >= -tolerance)
          n_sides += 1.;
        if (std::min(a, b) <= tolerance && std::max(a, b) > tolerance)
          n_sides += 1.;
      }
    return 0.5 * Utilities::MPI::sum(n_sides, communicator_of(triangulation));
  }



  template <>
  double
  modelled_part(const parallel::distributed::Triangulation<3> &triangulation,
                const std::set<types::boundary_id> &contact_boundaries,
                const Point<2>                     &position,
                const Kinematics /* cartesian */)
  {
    double angle = 0;
    for (const auto &[cell, f] : owned_faces(triangulation, contact_boundaries))
      {
        std::array<Tensor<1, 2>, 4> corners;
        for (const unsigned int v : cell->face(f)->vertex_indices())
          corners[v] = from_above(cell->face(f)->vertex(v)) - position;
        std::swap(corners[2], corners[3]); // around the face
        angle += angle_of_view(corners);
      }
    return Utilities::MPI::sum(angle, communicator_of(triangulation)) /
           (2 * numbers::PI);
  }



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



  template <int dim>
  std::optional<IndentationTest>
  make_indentation_test(
    const NominalContact<dim>                       &contact,
    const LoadedBody<dim>                           &body,
    const PlacedIndenter<dim>                       &indenter,
    const parallel::distributed::Triangulation<dim> &triangulation,
    const GapFunction<dim>                          &gap_function,
    const EvaluationParameters                      &constants)
  {
    const double part = contact.part_of_surroundings();
    if (!gap_function.has_indenter() || contact.is_strip() || part == 0.)
      return {};
    const auto boundaries =
      body.boundary_conditions.ids(BoundaryConditionType::contact);
    std::shared_ptr<const TipOnSurface> tip;
    if (are_level(triangulation, boundaries))
      tip = std::make_shared<TipOnLevelSurface>(indenter.shape,
                                                indenter.initial_gap,
                                                communicator_of(triangulation));
    else
      tip = std::make_shared<TipOnCurvedSurface<dim>>(
        indenter.shape, gap_function, triangulation, boundaries, part);
    return IndentationTest(tip, part, constants);
  }



  template class NominalContact<2>;
  template class NominalContact<3>;
  template std::optional<IndentationTest>
  make_indentation_test(const NominalContact<2> &,
                        const LoadedBody<2> &,
                        const PlacedIndenter<2> &,
                        const parallel::distributed::Triangulation<2> &,
                        const GapFunction<2> &,
                        const EvaluationParameters &);
  template std::optional<IndentationTest>
  make_indentation_test(const NominalContact<3> &,
                        const LoadedBody<3> &,
                        const PlacedIndenter<3> &,
                        const parallel::distributed::Triangulation<3> &,
                        const GapFunction<3> &,
                        const EvaluationParameters &);
} // namespace ElastoPlastic
