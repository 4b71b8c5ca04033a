// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "bounds/body/face_conditions.h"
#include "bounds/body/hencky_material.h"
#include "bounds/body/space_body.h"

namespace ElastoPlastic
{
  namespace
  {
    /// That the two tetrahedra at a face are on different sides of it. Of a
    /// hexahedron whose faces cannot all be seen from its centre, some are not.
    void
    check_orientation(const TetrahedralMesh &mesh)
    {
      for (const auto &face : mesh.faces)
        if (face.is_inside())
          {
            const TriangleFace    corners = mesh.corners(face);
            const Tensor<1, 3>    n       = normal(corners);
            std::array<double, 2> heights = {};
            for (unsigned int i = 0; i < 2; ++i)
              for (const unsigned int v :
                   mesh.tetrahedra[face.neighbors[i]].vertices)
                if (const double height = (mesh.vertices[v] - corners[0]) * n;
                    std::abs(height) > std::abs(heights[i]))
                  heights[i] = height;
            if (heights[0] * heights[1] >= 0)
              throw InputError(
                "A cell of the mesh near the point (" +
                Patterns::Tools::to_string(corners[0]) +
                ") is so distorted that the equilibrium method cannot cut it "
                "into tetrahedra: not all of its faces can be seen from its "
                "centre. Improve the mesh.");
          }
    }



    /// See the function of plane bodies.
    double
    pressed_part(const FaceCondition::Component &component,
                 const Tensor<1, 3>             &normal)
    {
      return component.type == SideConditionType::continuous ?
               0. :
               normal * component.direction;
    }



    double
    largest_growth(const SpaceBody &body)
    {
      double largest = body.body_force_growth.norm() * body.length_unit;
      for (const FaceCondition &condition : body.conditions)
        for (const auto &component : condition.components)
          for (const double growth : component.growths)
            largest = std::max(largest, std::abs(growth));
      return largest;
    }
  } // namespace



  double
  SpaceBody::load(const unsigned int f,
                  const unsigned int c,
                  const unsigned int corner) const
  {
    const TriangleFace corners   = mesh.corners(mesh.faces[f]);
    const auto        &component = conditions[f].components[c];
    return component.values[corner] +
           pressed_part(component, outward_normal(f)) *
             pressure_of_body_force(corners[corner], 0.);
  }



  double
  SpaceBody::growth(const unsigned int f,
                    const unsigned int c,
                    const unsigned int corner) const
  {
    const TriangleFace corners   = mesh.corners(mesh.faces[f]);
    const auto        &component = conditions[f].components[c];
    return component.growths[corner] +
           pressed_part(component, outward_normal(f)) *
             (pressure_of_body_force(corners[corner], 1.) -
              pressure_of_body_force(corners[corner], 0.));
  }



  double
  SpaceBody::pressure_of_body_force(const Point<3> &x,
                                    const double    load_factor) const
  {
    return (body_force + load_factor * body_force_growth) *
           (x - mesh.vertices.front());
  }



  FaceSupport
  SpaceBody::support_of(const unsigned int f) const
  {
    const FaceCondition &condition = conditions[f];
    FaceSupport          support;
    if (condition.is_reached)
      {
        support.resists_slip = indenter_surface == SurfaceFinish::rough;
        return support;
      }
    const Tensor<1, 3> n = normal(mesh.corners(mesh.faces[f]));
    for (const auto &component : condition.components)
      if (component.type == SideConditionType::displacement)
        {
          if (std::abs(component.direction * n) > small_angle)
            support.is_closed = true;
          if (cross_product_3d(component.direction, n).norm() > small_angle)
            support.resists_slip = true;
        }
    return support;
  }



  Tensor<1, 3>
  SpaceBody::outward_normal(const unsigned int f) const
  {
    const auto  &tetrahedron = mesh.tetrahedra[mesh.faces[f].neighbors[0]];
    unsigned int k           = 0;
    while (tetrahedron.faces[k] != f)
      ++k;
    return ElastoPlastic::outward_normal(mesh.corners(tetrahedron), k);
  }



  double
  SpaceBody::area_of_corner(const unsigned int f) const
  {
    return area(mesh.corners(mesh.faces[f])) / (3. * length_unit * length_unit);
  }



  double
  SpaceBody::shear_strength(const unsigned int f) const
  {
    double radius = std::numeric_limits<double>::infinity();
    for (const unsigned int t : mesh.faces[f].neighbors)
      if (t != numbers::invalid_unsigned_int)
        radius = std::min(radius, materials[t].yield_radius);
    return std::sqrt(0.5) * radius;
  }



  SpaceBody
  make_space_body(TetrahedralMesh                                mesh,
                  const BoundaryConditions<3>                   &conditions,
                  const std::vector<Material<double>>           &materials,
                  const std::function<double(const Point<3> &)> &gap,
                  const Loads<3>                                &loads,
                  const SurfaceFinish indenter_surface,
                  const Footprint<2> &footprint)
  {
    check_orientation(mesh);
    SpaceBody body;
    body.mesh             = std::move(mesh);
    body.indenter_surface = indenter_surface;
    body.gap              = gap;
    body.footprint        = footprint;

    const FaceConditions condition_of(
      conditions, gap, footprint, loads, indenter_surface);
    for (const auto &face : body.mesh.faces)
      body.conditions.push_back(
        condition_of(body.mesh.corners(face), face.boundary_id));
    for (const auto &tetrahedron : body.mesh.tetrahedra)
      body.materials.push_back(
        materials.size() == 1 ?
          materials.front() :
          materials[body.mesh.cells[tetrahedron.cell].material_id]);

    const auto [stress, strain] = HenckyMaterial::units_of(materials);
    body.stress_unit            = stress;
    body.strain_unit            = strain;
    for (const Point<3> &vertex : body.mesh.vertices)
      body.length_unit =
        std::max(body.length_unit, vertex.distance(body.mesh.vertices.front()));

    const auto force_at = [&](const double time) {
      return loads.constant_body_force(body.mesh.vertices, time);
    };
    body.body_force        = loads.constant_part(force_at);
    body.body_force_growth = loads.growing_part(force_at);
    if (const double growth = largest_growth(body); growth > 0)
      {
        body.load_factor_unit  = body.stress_unit / growth;
        body.indenter_velocity = Tensor<1, 3>();
      }
    return body;
  }
} // namespace ElastoPlastic
