// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/body/hencky_material.h"
#include "bounds/body/side_conditions.h"

namespace ElastoPlastic
{
  namespace
  {
    void
    set_body_force(PlaneBody &body, const Loads<2> &loads)
    {
      const auto at = [&](const double time) {
        return loads.constant_body_force(body.mesh.vertices, time);
      };
      body.body_force        = loads.constant_part(at);
      body.body_force_growth = loads.growing_part(at);
    }



    /// The largest load that grows, as a stress.
    double
    largest_growth(const PlaneBody &body)
    {
      double largest = body.body_force_growth.norm() * body.length_unit;
      for (unsigned int s = 0; s < body.mesh.sides.size(); ++s)
        for (const auto &component : body.conditions[s].components)
          if (component.type == SideConditionType::traction)
            for (const unsigned int vertex : body.mesh.sides[s].vertices)
              largest = std::max(largest,
                                 std::abs(component.growth(
                                   body.mesh.vertices[vertex])));
      return largest;
    }



    /// Of a pressure on a side with this @p normal: what is in the direction of
    /// a component. Within the body, both triangles bear the same one.
    double
    pressed_part(const SideCondition::Component &component,
                 const Tensor<1, 2>             &normal)
    {
      return component.type == SideConditionType::continuous ?
               0. :
               normal * component.direction;
    }



    void
    choose_units(PlaneBody                           &body,
                 const std::vector<Material<double>> &materials)
    {
      const auto [stress, strain] = HenckyMaterial::units_of(materials);
      body.stress_unit            = stress;
      body.strain_unit            = strain;

      double square = 0;
      for (const Point<2> &vertex : body.mesh.vertices)
        square =
          std::max(square, vertex.distance_square(body.mesh.vertices.front()));
      body.length_unit = std::sqrt(square);

      if (const double growth = largest_growth(body); growth > 0)
        {
          body.load_factor_unit  = body.stress_unit / growth;
          body.indenter_velocity = Tensor<1, 2>();
        }
    }
  } // namespace



  bool
  PlaneBody::is_axisymmetric() const
  {
    return kinematics == Kinematics::axisymmetric;
  }



  bool
  PlaneBody::is_on_axis(const Point<2> &x) const
  {
    constexpr double rounding = 1e-12;
    return is_axisymmetric() && x[0] <= rounding * length_unit;
  }



  double
  PlaneBody::weight(const Point<2> &x) const
  {
    return is_axisymmetric() ? x[0] : 1.;
  }



  double
  PlaneBody::weight_unit() const
  {
    return is_axisymmetric() ? length_unit : 1.;
  }



  double
  PlaneBody::angle() const
  {
    return is_axisymmetric() ? 2. * numbers::PI : 1.;
  }



  double
  PlaneBody::volume(const unsigned int triangle) const
  {
    const auto corners = mesh.corners(mesh.triangles[triangle]);
    return angle() * area(corners) *
           (weight(corners[0]) + weight(corners[1]) + weight(corners[2])) / 3.;
  }



  double
  PlaneBody::load(const SideCondition::Component &component,
                  const Tensor<1, 2>             &normal,
                  const Point<2>                 &x) const
  {
    return component.value(x) +
           pressed_part(component, normal) * pressure_of_body_force(x, 0.);
  }



  double
  PlaneBody::growth(const SideCondition::Component &component,
                    const Tensor<1, 2>             &normal,
                    const Point<2>                 &x) const
  {
    return component.growth(x) +
           pressed_part(component, normal) *
             (pressure_of_body_force(x, 1.) - pressure_of_body_force(x, 0.));
  }



  double
  PlaneBody::pressure_of_body_force(const Point<2> &x,
                                    const double    load_factor) const
  {
    return (body_force + load_factor * body_force_growth) *
           (x - mesh.vertices.front());
  }



  PlaneBody
  make_plane_body(SplitMesh                                      mesh,
                  const BoundaryConditions<2>                   &conditions,
                  const std::vector<Material<double>>           &materials,
                  const Kinematics                               kinematics,
                  const std::function<double(const Point<2> &)> &gap,
                  const Loads<2>                                &loads,
                  const SurfaceFinish                            surface,
                  const ContactGeometry                          geometry,
                  const Footprint<1>                            &footprint)
  {
    PlaneBody body;
    body.mesh             = std::move(mesh);
    body.kinematics       = kinematics;
    body.indenter_surface = surface;
    body.gap              = gap;

    set_body_force(body, loads);

    const SideConditions condition_of(
      conditions, gap, loads, surface, geometry, footprint);
    for (const SplitMesh::Side &side : body.mesh.sides)
      body.conditions.push_back(condition_of(body.mesh, side));
    for (const SplitMesh::Triangle &triangle : body.mesh.triangles)
      body.materials.push_back(
        materials.size() == 1 ?
          materials.front() :
          materials[body.mesh.cells[triangle.cell].material_id]);
    choose_units(body, materials);
    return body;
  }
} // namespace ElastoPlastic
