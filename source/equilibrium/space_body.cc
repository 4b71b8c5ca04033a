// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "equilibrium/hencky_material.h"
#include "equilibrium/space_body.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Cosine and sine below which directions are at right angles or parallel.
    constexpr double small_angle = 1e-10;



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



    /// Tells the conditions of faces from those of the boundaries.
    class FaceConditions
    {
    public:
      FaceConditions(const BoundaryConditions<3>                   &conditions,
                     const std::function<double(const Point<3> &)> &gap,
                     const Loads<3>                                &loads,
                     const SurfaceFinish indenter_surface)
        : contact(conditions.ids(BoundaryConditionType::contact))
        , fixed(conditions.ids(BoundaryConditionType::fixed))
        , rollers(conditions.ids(BoundaryConditionType::roller))
        , displacements(conditions.prescribed_displacements())
        , tractions(conditions.tractions())
        , gap(gap)
        , loads(loads)
        , indenter_surface(indenter_surface)
      {}

      FaceCondition
      operator()(const TriangleFace &corners, const types::boundary_id id) const
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
                  prescribe(condition.components[d],
                            *found->second[d],
                            corners);
                }
        return condition;
      }

    private:
      using Values =
        std::map<types::boundary_id, BoundaryConditions<3>::Components>;

      static FaceCondition
      along_axes(const std::array<SideConditionType, 3> &types)
      {
        FaceCondition condition;
        for (unsigned int d = 0; d < 3; ++d)
          condition.components[d] = {Point<3>::unit_vector(d), types[d]};
        return condition;
      }

      static FaceCondition
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

      void
      press(FaceCondition &condition, const TriangleFace &corners) const
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
      prescribe(FaceCondition::Component &component,
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

      template <typename Function>
      static std::array<double, 3>
      values_at_corners(const TriangleFace &corners, const Function &function)
      {
        constexpr double rounding = 1e-9;

        std::array<double, 3> values;
        double                largest = 0;
        for (unsigned int i = 0; i < 3; ++i)
          {
            values[i] = function(corners[i]);
            largest   = std::max(largest, std::abs(values[i]));
          }
        for (unsigned int i = 0; i < 3; ++i)
          {
            const unsigned int j = (i + 1) % 3;
            const Point<3>     middle(0.5 * (corners[i] + corners[j]));
            if (std::abs(function(middle) - 0.5 * (values[i] + values[j])) >
                rounding * largest)
              throw InputError(
                "A traction or displacement of 'Boundary conditions' is not "
                "linear on the faces of the mesh. In space, the equilibrium "
                "method is for such that are linear functions of x, y and z.");
          }
        return values;
      }

      /// How much of a face the indenter can touch.
      enum class Reach
      {
        none,
        part,
        whole
      };

      Reach
      reach_of(const TriangleFace &corners) const
      {
        constexpr unsigned int n_intervals = 8;
        constexpr double       inset       = 1e-6;

        const Point<3> center((corners[0] + corners[1] + corners[2]) / 3.);
        unsigned int   n_finite = 0, n_points = 0;
        for (unsigned int i = 0; i <= n_intervals; ++i)
          for (unsigned int j = 0; i + j <= n_intervals; ++j, ++n_points)
            {
              const double a = i / double(n_intervals),
                           b = j / double(n_intervals);
              const Point<3> x(corners[0] + a * (corners[1] - corners[0]) +
                               b * (corners[2] - corners[0]));
              if (std::isfinite(gap(Point<3>(x + inset * (center - x)))))
                ++n_finite;
            }
        return n_finite == 0       ? Reach::none :
               n_finite < n_points ? Reach::part :
                                     Reach::whole;
      }

      const std::set<types::boundary_id>             contact;
      const std::set<types::boundary_id>             fixed;
      const std::set<types::boundary_id>             rollers;
      const Values                                  &displacements;
      const Values                                  &tractions;
      const std::function<double(const Point<3> &)> &gap;
      const Loads<3>                                &loads;
      const SurfaceFinish                            indenter_surface;
    };



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
                  const SurfaceFinish indenter_surface)
  {
    check_orientation(mesh);
    SpaceBody body;
    body.mesh             = std::move(mesh);
    body.indenter_surface = indenter_surface;
    body.gap              = gap;

    const FaceConditions condition_of(conditions, gap, loads, indenter_surface);
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
