// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/exceptions.h"
#include "bounds/body/face_conditions.h"
#include "bounds/body/from_inside.h"

namespace ElastoPlastic
{
  namespace
  {
    FaceCondition
    along_axes(const std::array<SideConditionType, 3> &types)
    {
      FaceCondition condition;
      for (unsigned int d = 0; d < 3; ++d)
        condition.components[d] = {Point<3>::unit_vector(d), types[d]};
      return condition;
    }



    FaceCondition
    on_roller(const TriangleFace &corners)
    {
      const auto    across = tangents(corners);
      FaceCondition condition;
      condition.components = {
        {{normal(corners), SideConditionType::displacement},
         {across[0], SideConditionType::traction},
         {across[1], SideConditionType::traction}}};
      return condition;
    }



    /// Whether @p function is linear on a face, with these @p values at its
    /// @p corners.
    bool
    is_linear(const TriangleFace                            &corners,
              const std::array<double, 3>                   &values,
              const std::function<double(const Point<3> &)> &function)
    {
      constexpr double rounding = 1e-9;

      const double largest = std::max(
        {std::abs(values[0]), std::abs(values[1]), std::abs(values[2])});
      // Neither of a regular mesh, nor of one that is finer.
      static const QWitherdenVincentSimplex<2> inside(4);
      for (const Point<2> &x : inside.get_points())
        {
          const double   rest = 1. - x[0] - x[1];
          const Point<3> point(rest * corners[0] + x[0] * corners[1] +
                               x[1] * corners[2]);
          const double   linear =
            rest * values[0] + x[0] * values[1] + x[1] * values[2];
          const double value = function(point);
          if (!(std::abs(value - linear) <=
                rounding * std::max(largest, std::abs(value))))
            return false;
        }
      return true;
    }



    /// From inside where the function jumps at a corner.
    std::array<double, 3>
    values_at_corners(const TriangleFace                            &corners,
                      const std::function<double(const Point<3> &)> &function)
    {
      const Point<3>        centre((corners[0] + corners[1] + corners[2]) / 3.);
      std::array<double, 3> values, values_inside;
      for (unsigned int i = 0; i < 3; ++i)
        {
          values[i]        = function(corners[i]);
          values_inside[i] = function(from_inside(corners[i], centre));
        }
      if (is_linear(corners, values, function))
        return values;
      if (is_linear(corners, values_inside, function))
        return values_inside;
      throw InputError(
        "A traction or displacement of 'Boundary conditions' is not linear on "
        "the faces of the mesh, near the point (" +
        Patterns::Tools::to_string(centre) +
        "). In space, the equilibrium method is for such that are linear "
        "functions of x, y and z on each face. Put jumps and kinks on edges of "
        "the mesh.");
    }
  } // namespace



  FaceConditions::FaceConditions(
    const BoundaryConditions<3>                   &conditions,
    const std::function<double(const Point<3> &)> &gap,
    const Footprint<2>                            &footprint,
    const Loads<3>                                &loads,
    const SurfaceFinish                            indenter_surface)
    : contact(conditions.ids(BoundaryConditionType::contact))
    , fixed(conditions.ids(BoundaryConditionType::fixed))
    , rollers(conditions.ids(BoundaryConditionType::roller))
    , displacements(conditions.prescribed_displacements())
    , tractions(conditions.tractions())
    , gap(gap)
    , footprint(footprint)
    , loads(loads)
    , indenter_surface(indenter_surface)
  {}



  FaceCondition
  FaceConditions::operator()(const TriangleFace      &corners,
                             const types::boundary_id id) const
  {
    using Type = SideConditionType;
    if (id == numbers::internal_face_boundary_id)
      return along_axes(
        {{Type::continuous, Type::continuous, Type::continuous}});
    if (fixed.count(id) > 0)
      return along_axes(
        {{Type::displacement, Type::displacement, Type::displacement}});
    if (rollers.count(id) > 0)
      return on_roller(corners);
    FaceCondition condition =
      along_axes({{Type::traction, Type::traction, Type::traction}});
    if (contact.count(id) > 0)
      press(condition, corners);
    for (const auto &[type, values] :
         {std::pair(Type::displacement, &displacements),
          std::pair(Type::traction, &tractions)})
      if (const auto found = values->find(id); found != values->end())
        for (unsigned int d = 0; d < 3; ++d)
          if (found->second[d])
            {
              condition.components[d].type = type;
              prescribe(condition.components[d], *found->second[d], corners);
            }
    return condition;
  }



  void
  FaceConditions::press(FaceCondition      &condition,
                        const TriangleFace &corners) const
  {
    const Reach reach    = reach_of(corners);
    condition.is_reached = reach != Reach::none;
    const bool is_rough  = indenter_surface == SurfaceFinish::rough;
    if (condition.is_reached && is_rough &&
        std::hypot(normal(corners)[0], normal(corners)[1]) > small_angle)
      throw InputError("Indenter/Surface",
                       "rough",
                       "the bounds of a rough indenter are for contact "
                       "boundaries that are level where it can touch. "
                       "Choose 'smooth', or reduce 'Indenter/Reach'.");
    if (reach != Reach::whole)
      return;
    condition.components[2].type = SideConditionType::contact;
    if (is_rough)
      for (unsigned int d = 0; d < 2; ++d)
        condition.components[d].type = SideConditionType::displacement;
  }



  void
  FaceConditions::prescribe(FaceCondition::Component &component,
                            const Expression<3>      &expression,
                            const TriangleFace       &corners) const
  {
    const auto at = [&](const Point<3> &x) {
      return [&expression, x](const double time) {
        return expression.value(x, time);
      };
    };
    component.values = values_at_corners(corners, [&](const auto &x) {
      return loads.constant_part(at(x));
    });
    if (component.type == SideConditionType::traction)
      component.growths = values_at_corners(corners, [&](const auto &x) {
        return loads.growing_part(at(x));
      });
  }



  // Points of the face must do where nothing else is known than the gap at
  // points.
  FaceConditions::Reach
  FaceConditions::reach_of(const TriangleFace &corners) const
  {
    if (footprint.is_known())
      return contains(footprint, corners) ? Reach::whole :
             overlaps(footprint, corners) ? Reach::part :
                                            Reach::none;

    constexpr unsigned int n_intervals = 8;
    constexpr double       inset       = 1e-6;

    const Point<3> center((corners[0] + corners[1] + corners[2]) / 3.);
    unsigned int   n_finite = 0, n_points = 0;
    for (unsigned int i = 0; i <= n_intervals; ++i)
      for (unsigned int j = 0; i + j <= n_intervals; ++j, ++n_points)
        {
          const double a = i / double(n_intervals), b = j / double(n_intervals);
          const Point<3> x(corners[0] + a * (corners[1] - corners[0]) +
                           b * (corners[2] - corners[0]));
          if (std::isfinite(gap(Point<3>(x + inset * (center - x)))))
            ++n_finite;
        }
    return n_finite == 0       ? Reach::none :
           n_finite < n_points ? Reach::part :
                                 Reach::whole;
  }
} // namespace ElastoPlastic
