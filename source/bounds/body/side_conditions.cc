// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "base/exceptions.h"
#include "bounds/body/from_inside.h"
#include "bounds/body/side_conditions.h"

namespace ElastoPlastic
{
  namespace
  {
    /// At so many points, the gap is looked at.
    constexpr unsigned int n_gaps = 9;

    const SideCondition::Value zero = [](const Point<2> &) {
      return 0.;
    };



    SideCondition
    along_axes(const SideConditionType x, const SideConditionType y)
    {
      return {{{{Tensor<1, 2>({1., 0.}), x, zero},
                {Tensor<1, 2>({0., 1.}), y, zero}}}};
    }
  } // namespace



  SideConditions::SideConditions(
    const BoundaryConditions<2>                   &conditions,
    const std::function<double(const Point<2> &)> &gap,
    const Loads<2>                                &loads,
    const SurfaceFinish                            indenter_surface,
    const ContactGeometry                          geometry,
    const Footprint<1>                            &footprint)
    : contact(conditions.ids(BoundaryConditionType::contact))
    , fixed(conditions.ids(BoundaryConditionType::fixed))
    , rollers(conditions.ids(BoundaryConditionType::roller))
    , displacements(conditions.prescribed_displacements())
    , tractions(conditions.tractions())
    , gap(gap)
    , loads(loads)
    , indenter_surface(indenter_surface)
    , geometry(geometry)
    , footprint(footprint)
  {}



  SideCondition
  SideConditions::operator()(const SplitMesh       &mesh,
                             const SplitMesh::Side &side) const
  {
    const types::boundary_id id = side.boundary_id;
    if (id == numbers::internal_face_boundary_id)
      return along_axes(SideConditionType::continuous,
                        SideConditionType::continuous);
    if (fixed.count(id) > 0)
      return along_axes(SideConditionType::displacement,
                        SideConditionType::displacement);
    const Reach reach =
      contact.count(id) > 0 ? reach_of(mesh, side) : Reach::none;
    if (reach != Reach::none && indenter_surface == SurfaceFinish::rough &&
        std::abs(mesh.normal(side)[0]) > 1e-10)
      throw InputError("Indenter/Surface",
                       "rough",
                       "the bounds of a rough indenter are for contact "
                       "boundaries that are level where it can touch. "
                       "Choose 'smooth', or reduce 'Indenter/Reach'.");
    SideCondition condition =
      reach == Reach::whole ?
        under_indenter() :
        along_axes(SideConditionType::traction, SideConditionType::traction);
    condition.is_reached = reach != Reach::none;
    if (condition.is_reached && presses_across(mesh, side))
      {
        const Tensor<1, 2> normal         = mesh.normal(side);
        condition.components[0].direction = cross_product_2d(normal);
        condition.components[1].direction = normal;
      }
    if (rollers.count(id) > 0)
      {
        const Tensor<1, 2> normal = mesh.normal(side);
        condition.components      = {
               {{normal, SideConditionType::displacement, zero},
                {cross_product_2d(normal), SideConditionType::traction, zero}}};
      }
    const Point<2> centre(0.5 * (mesh.vertices[side.vertices[0]] +
                                 mesh.vertices[side.vertices[1]]));
    prescribe(
      condition, SideConditionType::displacement, displacements, id, centre);
    prescribe(condition, SideConditionType::traction, tractions, id, centre);
    return condition;
  }



  SideCondition
  SideConditions::under_indenter() const
  {
    return along_axes(indenter_surface == SurfaceFinish::rough ?
                        SideConditionType::displacement :
                        SideConditionType::traction,
                      SideConditionType::contact);
  }



  void
  SideConditions::prescribe(SideCondition           &condition,
                            const SideConditionType  type,
                            const Values            &values,
                            const types::boundary_id id,
                            const Point<2>          &centre) const
  {
    const auto found = values.find(id);
    if (found == values.end())
      return;
    for (unsigned int d = 0; d < 2; ++d)
      if (found->second[d])
        {
          const auto at = [expression = found->second[d],
                           centre](const Point<2> &x) {
            return
              [expression, inside = from_inside(x, centre)](const double time) {
                return expression->value(inside, time);
              };
          };
          condition.components[d] = {Point<2>::unit_vector(d),
                                     type,
                                     [at, loads = loads](const Point<2> &x) {
                                       return loads.constant_part(at(x));
                                     },
                                     [at, loads = loads](const Point<2> &x) {
                                       return loads.growing_part(at(x));
                                     }};
        }
  }



  std::vector<double>
  SideConditions::gaps_of(const SplitMesh       &mesh,
                          const SplitMesh::Side &side) const
  {
    constexpr double inset = 1e-6;

    const Point<2> a = mesh.vertices[side.vertices[0]],
                   b = mesh.vertices[side.vertices[1]];
    std::vector<double> gaps;
    for (unsigned int i = 0; i < n_gaps; ++i)
      {
        const double t = inset + (1. - 2. * inset) * i / (n_gaps - 1.);
        if (const double value = gap(Point<2>(a + t * (b - a)));
            std::isfinite(value))
          gaps.push_back(value);
      }
    return gaps;
  }



  // Points of the side must do where nothing else is known than the gap at
  // points.
  SideConditions::Reach
  SideConditions::reach_of(const SplitMesh       &mesh,
                           const SplitMesh::Side &side) const
  {
    if (footprint.is_known())
      {
        const std::array<Point<2>, 2> ends = {
          {mesh.vertices[side.vertices[0]], mesh.vertices[side.vertices[1]]}};
        return contains(footprint, ends) ? Reach::whole :
               overlaps(footprint, ends) ? Reach::part :
                                           Reach::none;
      }
    const auto n_finite = gaps_of(mesh, side).size();
    return n_finite == 0     ? Reach::none :
           n_finite < n_gaps ? Reach::part :
                               Reach::whole;
  }



  bool
  SideConditions::presses_across(const SplitMesh       &mesh,
                                 const SplitMesh::Side &side) const
  {
    constexpr double rounding = 1e-6;

    if (geometry != ContactGeometry::automatic)
      return geometry == ContactGeometry::normal;
    const auto gaps = gaps_of(mesh, side);
    return !gaps.empty() &&
           std::abs(gaps.front() - gaps.back()) <= rounding * mesh.length(side);
  }
} // namespace ElastoPlastic
