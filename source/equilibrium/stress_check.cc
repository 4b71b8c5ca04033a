// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "equilibrium/hencky_material.h"
#include "equilibrium/johnson_mercier.h"
#include "equilibrium/stress_check.h"

namespace ElastoPlastic
{
  namespace
  {
    using namespace JohnsonMercier;

    void
    enlarge(double &largest, const double error)
    {
      largest = std::max(largest, error);
    }



    /// 1 / weight off the axis, 0 on it.
    double
    inverse_weight(const PlaneBody &body, const Point<2> &x)
    {
      return body.is_on_axis(x) ? 0. : 1. / body.weight(x);
    }



    /// Of the weighted stress on a subtriangle, by differences between its
    /// @p corners.
    Tensor<1, 2>
    divergence(const Triangle       &corners,
               const Vector<double> &values,
               const unsigned int    subtriangle)
    {
      const Tensor<2, 2> ways = invert(Tensor<2, 2>(
        {{corners[1][0] - corners[0][0], corners[1][1] - corners[0][1]},
         {corners[2][0] - corners[0][0], corners[2][1] - corners[0][1]}}));
      Tensor<1, 2>       result;
      for (unsigned int i = 0; i < 2; ++i)
        {
          const auto change = stress_at(values, subtriangle, i + 1) -
                              stress_at(values, subtriangle, 0);
          for (unsigned int d = 0; d < 2; ++d)
            result += ways[d][i] * (change * Point<2>::unit_vector(d));
        }
      return result;
    }



    /// The weighted tractions of a triangle at the ends of a side, in the
    /// direction of the side, on a plane with the normal of the side.
    std::array<Tensor<1, 2>, 2>
    tractions(const PlaneBody   &body,
              const StressField &field,
              const unsigned int t,
              const unsigned int k)
    {
      const auto                 &triangle = body.mesh.triangles[t];
      const auto                 &side     = body.mesh.sides[triangle.sides[k]];
      const Tensor<1, 2>          normal   = body.mesh.normal(side);
      std::array<Tensor<1, 2>, 2> result   = {
          {stress_at(field.in_plane[t], k, 0) * normal,
           stress_at(field.in_plane[t], k, 1) * normal}};
      if (side.vertices[0] != triangle.vertices[k])
        std::swap(result[0], result[1]);
      return result;
    }



    /// That S has the divergence that the circumferential stress asks for.
    void
    check_equilibrium(StressErrors      &errors,
                      const PlaneBody   &body,
                      const StressField &field,
                      const unsigned int t)
    {
      const auto   corners = body.mesh.corners(body.mesh.triangles[t]);
      const double size    = std::sqrt(area(corners));
      for (unsigned int k = 0; k < 3; ++k)
        {
          const Triangle subtriangle = subtriangle_of(corners, k);
          Tensor<1, 2> missing = divergence(subtriangle, field.in_plane[t], k);
          if (body.is_axisymmetric())
            missing[0] -= field.circumferential[t][k];
          enlarge(errors.divergence,
                  size * missing.norm() / body.weight(subtriangle[2]));
        }
    }



    /// That the tractions are continuous between the subtriangles.
    void
    check_lines_inside(StressErrors      &errors,
                       const PlaneBody   &body,
                       const StressField &field,
                       const unsigned int t)
    {
      const auto  corners = body.mesh.corners(body.mesh.triangles[t]);
      const auto &values  = field.in_plane[t];
      for (unsigned int k = 0; k < 3; ++k)
        {
          const Point<2>     center = subtriangle_of(corners, k)[2];
          const Tensor<1, 2> line   = center - corners[k];
          const Tensor<1, 2> normal = cross_product_2d(line) / line.norm();
          const unsigned int before = (k + 2) % 3;
          for (const auto &[here, there, point] :
               {std::make_tuple(0u, 1u, corners[k]),
                std::make_tuple(2u, 2u, center)})
            enlarge(errors.traction_jump,
                    inverse_weight(body, point) *
                      ((stress_at(values, k, here) -
                        stress_at(values, before, there)) *
                       normal)
                        .norm());
        }
    }



    /// The yield condition, and what makes it hold for the circumferential
    /// stress and on the axis.
    void
    check_points(StressErrors      &errors,
                 const PlaneBody   &body,
                 const StressField &field,
                 const unsigned int t)
    {
      const auto corners = body.mesh.corners(body.mesh.triangles[t]);
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int i = 0; i < 3; ++i)
          {
            const Point<2> point    = subtriangle_of(corners, k)[i];
            const auto     weighted = field.at(t, k, i);
            if (body.is_on_axis(point))
              enlarge(errors.on_axis,
                      weighted.norm() / std::sqrt(area(corners)));
            else if (body.is_axisymmetric())
              enlarge(errors.circumferential,
                      std::abs(weighted[2][2] / point[0] -
                               field.circumferential[t][k]));
            if (!HenckyMaterial::hardens(body.materials[t]))
              enlarge(errors.yield_excess,
                      inverse_weight(body, point) * deviator(weighted).norm() -
                        body.materials[t].yield_radius);
          }
    }



    /// Of a side at the boundary, where the pressure of body forces counts.
    /// @return the force of the indenter.
    double
    check_boundary(StressErrors                      &errors,
                   const PlaneBody                   &body,
                   const StressField                 &field,
                   const unsigned int                 s,
                   const std::array<Tensor<1, 2>, 2> &tractions)
    {
      double       force  = 0;
      const auto  &side   = body.mesh.sides[s];
      const double length = body.mesh.length(side);
      for (unsigned int end = 0; end < 2; ++end)
        for (const auto &component : body.conditions[s].components)
          {
            const Point<2> point = body.mesh.vertices[side.vertices[end]];
            const double   pressure =
              body.pressure_of_body_force(point, field.load_factor) *
              (body.mesh.normal(side) * component.direction);
            const double weighted = tractions[end] * component.direction -
                                    body.weight(point) * pressure;
            const double traction = inverse_weight(body, point) * weighted;
            if (component.type == SideConditionType::traction &&
                !body.is_on_axis(point))
              enlarge(errors.boundary_force,
                      std::abs(traction - component.value(point) -
                               field.load_factor * component.growth(point)));
            if (component.type == SideConditionType::contact)
              {
                enlarge(errors.tension, traction);
                force -= body.angle() * 0.5 * length * weighted *
                         component.direction[1];
              }
          }
      return force;
    }
  } // namespace



  double
  StressErrors::largest() const
  {
    return std::max({divergence,
                     on_axis,
                     circumferential,
                     traction_jump,
                     boundary_force,
                     tension,
                     yield_excess,
                     force_difference});
  }



  StressErrors
  check_stress(const PlaneBody &body, const StressField &field)
  {
    StressErrors                             errors;
    double                                   force = 0;
    std::vector<std::array<Tensor<1, 2>, 2>> first(body.mesh.sides.size());
    std::vector<bool> seen(body.mesh.sides.size(), false);
    for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
      {
        check_equilibrium(errors, body, field, t);
        check_lines_inside(errors, body, field, t);
        check_points(errors, body, field, t);
        for (unsigned int k = 0; k < 3; ++k)
          {
            const unsigned int s    = body.mesh.triangles[t].sides[k];
            const auto         here = tractions(body, field, t, k);
            if (body.mesh.sides[s].boundary_id !=
                numbers::internal_face_boundary_id)
              force += check_boundary(errors, body, field, s, here);
            else if (!seen[s])
              first[s] = here;
            else
              for (unsigned int end = 0; end < 2; ++end)
                {
                  const auto &vertices = body.mesh.sides[s].vertices;
                  enlarge(errors.traction_jump,
                          inverse_weight(body,
                                         body.mesh.vertices[vertices[end]]) *
                            (here[end] - first[s][end]).norm());
                }
            seen[s] = true;
          }
      }

    for (double *error : {&errors.divergence,
                          &errors.on_axis,
                          &errors.circumferential,
                          &errors.traction_jump,
                          &errors.boundary_force,
                          &errors.tension,
                          &errors.yield_excess})
      *error /= body.stress_unit;
    errors.force_difference = std::abs(force - field.force) /
                              std::max(std::abs(force),
                                       body.stress_unit * body.length_unit *
                                         body.weight_unit() * body.angle());
    return errors;
  }

} // namespace ElastoPlastic
