// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/exceptions.h"
#include "base/largest_error.h"
#include "bounds/body/face_conditions.h"
#include "bounds/body/hencky_material.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  namespace
  {
    /// That the two tetrahedra at a face are on different sides of it. Of a
    /// hexahedron whose faces cannot all be seen from its centre, some are not.
    void
    check_orientation(const SplitMesh<3> &mesh)
    {
      for (const auto &face : mesh.faces)
        if (face.is_inside())
          {
            const FaceCorners<3>  corners = mesh.corners(face);
            const Tensor<1, 3>    n       = normal(corners);
            std::array<double, 2> heights = {};
            for (unsigned int i = 0; i < 2; ++i)
              for (const unsigned int v :
                   mesh.simplices[face.neighbors[i]].vertices)
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



    template <int dim>
    void
    set_body_force(SplitBody<dim> &body, const Loads<dim> &loads)
    {
      const auto at = [&](const double time) {
        return loads.constant_body_force(body.mesh.vertices, time);
      };
      body.body_force      = loads.constant_part(at);
      body.live_body_force = loads.growing_part(at);
    }



    /// One of the two loads of the components of a FaceCondition.
    template <int dim>
    using LoadOfFace = FaceValue<dim> FaceCondition<dim>::Component::*;

    /// The largest @p load of a face or @p body_force, as a stress.
    template <int dim>
    double
    largest_load(const SplitBody<dim> &body,
                 const LoadOfFace<dim> load,
                 const Tensor<1, dim> &body_force)
    {
      double largest = body_force.norm() * body.length_unit;
      for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
        for (const auto &component : body.conditions[f].components)
          if (component.type == ConditionType::traction &&
              !(component.*load).is_zero())
            for (unsigned int i = 0; i < dim; ++i)
              keep_largest(largest,
                           std::abs((component.*load)(
                             corner_point<dim>(body.corners_of_face(f), i))));
      return largest;
    }



    template <int dim>
    void
    choose_units(SplitBody<dim>                      &body,
                 const std::vector<Material<double>> &materials)
    {
      const auto [stress, strain] = HenckyMaterial::units_of(materials);
      body.stress_unit            = stress;
      body.strain_unit            = strain;
      body.length_unit            = body.mesh.size();
      if (const double live_load =
            largest_load<dim>(body,
                              &FaceCondition<dim>::Component::live_load,
                              body.live_body_force);
          live_load > 0)
        {
          body.load_factor_unit  = body.stress_unit / live_load;
          body.indenter_velocity = Tensor<1, dim>();
        }
    }
  } // namespace



  template <int dim>
  double
  SplitBody<dim>::volume(const unsigned int simplex) const
  {
    const auto corners = corners_of(simplex);
    double     weights = 0;
    for (const Point<dim> &corner : corners)
      weights += weight(corner);
    return angle() * ElastoPlastic::volume(corners) * weights / (dim + 1.);
  }



  // Within the body, both neighbours bear the same pressure.
  template <int dim>
  TwoLoads
  SplitBody<dim>::loads(const unsigned int    face,
                        const unsigned int    component,
                        const FacePoint<dim> &point) const
  {
    if (mesh.faces[face].is_inside())
      return {};
    const auto  &given   = conditions[face].components[component];
    const double along   = outward_normal(face) * given.direction;
    const double at_zero = pressure_of_body_force(point.x, 0.);
    return {given.value(point) + along * at_zero,
            given.live_load(point) +
              along * (pressure_of_body_force(point.x, 1.) - at_zero)};
  }



  template <int dim>
  FaceSupport<dim>
  SplitBody<dim>::support_of(const unsigned int face) const
  {
    const FaceCondition<dim> &condition = conditions[face];
    FaceSupport<dim>          support;
    if (condition.is_reached)
      {
        support.resists_slip = indenter_surface == SurfaceFinish::rough;
        support.velocity     = indenter_velocity;
        return support;
      }
    const auto corners = corners_of_face(face);
    if (std::all_of(corners.begin(), corners.end(), [this](const auto &x) {
          return is_on_axis(x);
        }))
      return support;
    const Tensor<1, dim> n = normal(corners);
    for (const auto &component : condition.components)
      if (component.type == ConditionType::displacement)
        {
          const double across = component.direction * n;
          if (std::abs(across) > Tolerance::small_angle)
            support.is_closed = true;
          if ((component.direction - across * n).norm() >
              Tolerance::small_angle)
            support.resists_slip = true;
        }
    return support;
  }



  template <int dim>
  Tensor<1, dim>
  SplitBody<dim>::outward_normal(const unsigned int face) const
  {
    const auto           corners = corners_of_face(face);
    const Tensor<1, dim> n       = normal(corners);
    if (dim == 2)
      return n;
    const auto  &inside = mesh.simplices[mesh.faces[face].neighbors[0]];
    const double height =
      n *
      (mesh.corners(inside)[opposite_corner<dim>(inside.place_of_face(face))] -
       corners[0]);
    return height < 0. ? n : -n;
  }



  // See bounds/conic/yield_conditions.h. In plane strain, s_33 is the mean of
  // the others.
  template <int dim>
  double
  SplitBody<dim>::yield_radius(const unsigned int           simplex,
                               const SymmetricTensor<2, 3> &stress) const
  {
    const double without_pressure = materials[simplex].yield_radius;
    if (!has_friction())
      return without_pressure;
    const double mean = dim == 3 || is_axisymmetric() ?
                          trace(stress) / 3. :
                          (stress[0][0] + stress[1][1]) / 2.;
    return without_pressure - std::sqrt(2.) * friction_slopes[simplex] * mean;
  }



  template <int dim>
  double
  SplitBody<dim>::shear_strength(const unsigned int face) const
  {
    double radius = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < mesh.faces[face].n_neighbors(); ++i)
      radius =
        std::min(radius, materials[mesh.faces[face].neighbors[i]].yield_radius);
    return std::sqrt(0.5) * radius;
  }



  template <int dim>
  SplitBody<dim>
  make_split_body(SplitMesh<dim>                       mesh,
                  const BoundaryConditions<dim>       &conditions,
                  const std::vector<Material<double>> &materials,
                  const IndenterOnBody<dim>           &indenter,
                  const Loads<dim>                    &loads,
                  const Kinematics                     kinematics)
  {
    if constexpr (dim == 3)
      check_orientation(mesh);
    SplitBody<dim> body;
    body.mesh                   = std::move(mesh);
    body.place_without_pressure = body.mesh.vertices.front();
    body.kinematics             = kinematics;
    body.indenter_surface       = indenter.surface;
    body.gap                    = indenter.gap;
    body.footprint              = indenter.footprint;
    set_body_force(body, loads);

    body.conditions =
      conditions_of_faces(body.mesh, conditions, indenter, loads);
    for (const auto &simplex : body.mesh.simplices)
      body.materials.push_back(
        materials.size() == 1 ?
          materials.front() :
          materials[body.mesh.cells[simplex.cell].material_id]);
    choose_units(body, materials);
    return body;
  }



  // A strength that comes from the pressure of constant loads may be much
  // larger than the cohesion.
  template <int dim>
  void
  SplitBody<dim>::set_friction(const std::vector<double> &slopes)
  {
    const double largest_slope =
      *std::max_element(slopes.begin(), slopes.end());
    if (largest_slope == 0.)
      return;
    for (const auto &simplex : mesh.simplices)
      friction_slopes.push_back(slopes.size() == 1 ?
                                  slopes.front() :
                                  slopes[mesh.cells[simplex.cell].material_id]);
    const double factor =
      std::max(1.,
               largest_slope *
                 largest_load<dim>(*this,
                                   &FaceCondition<dim>::Component::value,
                                   body_force) /
                 stress_unit);
    stress_unit *= factor;
    strain_unit *= factor;
    load_factor_unit *= factor;
  }



  template <int dim>
  void
  SplitBody<dim>::set_initial_stress(const InitialStress<dim> &stress)
  {
    if (!stress.is_present())
      return;
    double     largest = 0, largest_distance = 0; // from what is linear
    Point<dim> worst_point;
    for (unsigned int t = 0; t < mesh.simplices.size(); ++t)
      {
        const auto                                 corners = corners_of(t);
        const auto                                 centre  = centre_of(corners);
        std::array<SymmetricTensor<2, 3>, dim + 1> at_corners;
        for (unsigned int i = 0; i <= dim; ++i)
          {
            at_corners[i] = stress.value(from_inside(corners[i], centre));
            keep_largest(largest, at_corners[i].norm());
          }
        for (const auto &[position, weight] : simplex_quadrature<dim>())
          {
            const Point<dim> x = interpolate(position, corners);
            const double     distance =
              (stress.value(x) - interpolate(position, at_corners)).norm();
            if (distance > largest_distance)
              worst_point = x;
            keep_largest(largest_distance, distance);
          }
        auto &strains = initial_strains.emplace_back();
        for (unsigned int i = 0; i <= dim; ++i)
          strains[i] = HenckyMaterial::compliance(materials[t], at_corners[i]);
      }
    if (!(largest_distance <= Tolerance::expression * largest))
      throw InputError(
        "The 'Initial stress' is not linear on the cells of the mesh, near the "
        "point (" +
        Patterns::Tools::to_string(worst_point) +
        "). An error bound is for stresses at the beginning that are linear "
        "functions of the position, or such with kinks at vertices of the "
        "mesh. Give such, or choose 'Analysis = contact'.");
  }



  template struct SplitBody<2>;
  template struct SplitBody<3>;
  template SplitBody<2>
  make_split_body(SplitMesh<2>,
                  const BoundaryConditions<2> &,
                  const std::vector<Material<double>> &,
                  const IndenterOnBody<2> &,
                  const Loads<2> &,
                  const Kinematics);
  template SplitBody<3>
  make_split_body(SplitMesh<3>,
                  const BoundaryConditions<3> &,
                  const std::vector<Material<double>> &,
                  const IndenterOnBody<3> &,
                  const Loads<3> &,
                  const Kinematics);
} // namespace ElastoPlastic
