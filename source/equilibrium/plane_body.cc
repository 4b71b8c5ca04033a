// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "base/exceptions.h"
#include "equilibrium/hencky_material.h"
#include "equilibrium/plane_body.h"

namespace ElastoPlastic
{
  namespace
  {
    const SideCondition::Value zero = [](const Point<2> &) {
      return 0.;
    };



    /// Tells the conditions of sides from those of the boundaries.
    class Conditions
    {
    public:
      Conditions(const BoundaryConditions<2>                   &conditions,
                 const std::function<double(const Point<2> &)> &gap,
                 const Loads<2>                                &loads,
                 const SurfaceFinish   indenter_surface,
                 const ContactGeometry geometry)
        : contact(conditions.ids(BoundaryConditionType::contact))
        , fixed(conditions.ids(BoundaryConditionType::fixed))
        , rollers(conditions.ids(BoundaryConditionType::roller))
        , displacements(conditions.prescribed_displacements())
        , tractions(conditions.tractions())
        , gap(gap)
        , loads(loads)
        , indenter_surface(indenter_surface)
        , geometry(geometry)
      {}

      SideCondition
      operator()(const SplitMesh &mesh, const SplitMesh::Side &side) const
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
        SideCondition condition = reach == Reach::whole ?
                                    under_indenter() :
                                    along_axes(SideConditionType::traction,
                                               SideConditionType::traction);
        condition.is_reached    = reach != Reach::none;
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
        prescribe(condition,
                  SideConditionType::displacement,
                  displacements,
                  id);
        prescribe(condition, SideConditionType::traction, tractions, id);
        return condition;
      }

    private:
      using Values =
        std::map<types::boundary_id, BoundaryConditions<2>::Components>;

      static SideCondition
      along_axes(const SideConditionType x, const SideConditionType y)
      {
        return {{{{Tensor<1, 2>({1., 0.}), x, zero},
                  {Tensor<1, 2>({0., 1.}), y, zero}}}};
      }

      SideCondition
      under_indenter() const
      {
        return along_axes(indenter_surface == SurfaceFinish::rough ?
                            SideConditionType::displacement :
                            SideConditionType::traction,
                          SideConditionType::contact);
      }

      void
      prescribe(SideCondition           &condition,
                const SideConditionType  type,
                const Values            &values,
                const types::boundary_id id) const
      {
        const auto found = values.find(id);
        if (found == values.end())
          return;
        for (unsigned int d = 0; d < 2; ++d)
          if (found->second[d])
            {
              const auto at = [expression =
                                 found->second[d]](const Point<2> &x) {
                return [expression, x](const double time) {
                  return expression->value(x, time);
                };
              };
              condition.components[d] = {
                Point<2>::unit_vector(d),
                type,
                [at, loads = loads](const Point<2> &x) {
                  return loads.constant_part(at(x));
                },
                [at, loads = loads](const Point<2> &x) {
                  return loads.growing_part(at(x));
                }};
            }
      }

      /// How much of a side the indenter can touch.
      enum class Reach
      {
        none,
        part,
        whole
      };

      static constexpr unsigned int n_gaps = 9;

      /// At equidistant points of a side, but where the indenter does not
      /// reach.
      std::vector<double>
      gaps_of(const SplitMesh &mesh, const SplitMesh::Side &side) const
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

      Reach
      reach_of(const SplitMesh &mesh, const SplitMesh::Side &side) const
      {
        const auto n_finite = gaps_of(mesh, side).size();
        return n_finite == 0     ? Reach::none :
               n_finite < n_gaps ? Reach::part :
                                   Reach::whole;
      }

      /// Whether the indenter presses across a side that it reaches. It fits
      /// the side if the gap is the same at both ends.
      bool
      presses_across(const SplitMesh &mesh, const SplitMesh::Side &side) const
      {
        constexpr double rounding = 1e-6;

        if (geometry != ContactGeometry::automatic)
          return geometry == ContactGeometry::normal;
        const auto gaps = gaps_of(mesh, side);
        return std::abs(gaps.front() - gaps.back()) <=
               rounding * mesh.length(side);
      }

      const std::set<types::boundary_id>             contact;
      const std::set<types::boundary_id>             fixed;
      const std::set<types::boundary_id>             rollers;
      const Values                                  &displacements;
      const Values                                  &tractions;
      const std::function<double(const Point<2> &)> &gap;
      const Loads<2>                                &loads;
      const SurfaceFinish                            indenter_surface;
      const ContactGeometry                          geometry;
    };



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
                  const ContactGeometry                          geometry)
  {
    PlaneBody body;
    body.mesh             = std::move(mesh);
    body.kinematics       = kinematics;
    body.indenter_surface = surface;
    body.gap              = gap;

    set_body_force(body, loads);

    const Conditions condition_of(conditions, gap, loads, surface, geometry);
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
