// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/largest_error.h"
#include "bounds/body/hencky_material.h"
#include "bounds/mesh/integration.h"
#include "bounds/stress/johnson_mercier.h"
#include "bounds/stress/stress_check.h"

namespace ElastoPlastic
{
  namespace
  {
    using namespace JohnsonMercier;

    /// 1 / weight off the axis, 0 on it.
    double
    inverse_weight(const PlaneBody &body, const Point<2> &x)
    {
      return body.is_on_axis(x) ? 0. : 1. / body.weight(x);
    }



    /// The coefficients of the divergence of the weighted stress on a
    /// subtriangle, by differences between those of the stress on the ways from
    /// its first corner.
    std::vector<Tensor<1, 2>>
    divergence(const Triangle       &corners,
               const Vector<double> &values,
               const unsigned int    subtriangle,
               const unsigned int    degree)
    {
      const Tensor<2, 2>        ways = invert(Tensor<2, 2>(
        {{corners[1][0] - corners[0][0], corners[1][1] - corners[0][1]},
                {corners[2][0] - corners[0][0], corners[2][1] - corners[0][1]}}));
      std::vector<Tensor<1, 2>> result;
      for (const auto &exponents : Bernstein::exponents(degree - 1))
        {
          const auto beside = [&](const unsigned int corner) {
            Bernstein::Exponents raised = exponents;
            ++raised[corner];
            return coefficient(values,
                               subtriangle,
                               Bernstein::number_of(raised));
          };
          Tensor<1, 2> sum;
          for (unsigned int i = 0; i < 2; ++i)
            for (unsigned int d = 0; d < 2; ++d)
              sum += 1. * degree * ways[d][i] *
                     ((beside(i + 1) - beside(0)) * Point<2>::unit_vector(d));
          result.push_back(sum);
        }
      return result;
    }



    /// The coefficients of the weighted traction of a triangle, in the
    /// direction of the side, on a plane with the normal of the side.
    std::vector<Tensor<1, 2>>
    tractions(const PlaneBody   &body,
              const StressField &field,
              const unsigned int t,
              const unsigned int k)
    {
      const auto               &triangle = body.mesh.triangles[t];
      const auto               &side     = body.mesh.sides[triangle.sides[k]];
      const Tensor<1, 2>        normal   = body.mesh.normal(side);
      std::vector<Tensor<1, 2>> result;
      for (unsigned int i = 0; i <= field.degree; ++i)
        result.push_back(coefficient(field.in_plane[t],
                                     k,
                                     number_on_line(field.degree, 0, 1, i)) *
                         normal);
      if (side.vertices[0] != triangle.vertices[k])
        std::reverse(result.begin(), result.end());
      return result;
    }



    /// The point of a line that a coefficient belongs to.
    Point<2>
    point_on_line(const Point<2>    &a,
                  const Point<2>    &b,
                  const unsigned int i,
                  const unsigned int degree)
    {
      return Point<2>(a + 1. * i / degree * (b - a));
    }



    Point<2>
    point_on_side(const PlaneBody   &body,
                  const unsigned int s,
                  const unsigned int i,
                  const unsigned int degree)
    {
      const auto &vertices = body.mesh.sides[s].vertices;
      return point_on_line(body.mesh.vertices[vertices[0]],
                           body.mesh.vertices[vertices[1]],
                           i,
                           degree);
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
          auto           missing =
            divergence(subtriangle, field.in_plane[t], k, field.degree);
          for (unsigned int i = 0; i < missing.size(); ++i)
            {
              if (body.is_axisymmetric())
                missing[i][0] -=
                  field.circumferential[t][missing.size() * k + i];
              enlarge(errors.divergence,
                      size * missing[i].norm() / body.weight(subtriangle[2]));
            }
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
          for (unsigned int i = 0; i <= field.degree; ++i)
            {
              const auto jump =
                coefficient(values, k, number_on_line(field.degree, 0, 2, i)) -
                coefficient(values,
                            (k + 2) % 3,
                            number_on_line(field.degree, 1, 2, i));
              const Point<2> point =
                point_on_line(corners[k], center, i, field.degree);
              enlarge(errors.traction_jump,
                      inverse_weight(body, point) * (jump * normal).norm());
            }
        }
    }



    /// The circumferential stress at a @p point of a subtriangle.
    double
    circumferential_at(const StressField            &field,
                       const unsigned int            t,
                       const unsigned int            k,
                       const Bernstein::Barycentric &point)
    {
      const auto functions = Bernstein::functions(field.degree - 1, point);
      return std::inner_product(functions.begin(),
                                functions.end(),
                                field.circumferential[t].begin() +
                                  functions.size() * k,
                                0.);
    }



    /// The yield condition, which holds everywhere if it does for the
    /// coefficients over those of the weight, and what makes it hold for the
    /// circumferential stress and on the axis.
    void
    check_points(StressErrors      &errors,
                 const PlaneBody   &body,
                 const StressField &field,
                 const unsigned int t)
    {
      const auto  corners = body.mesh.corners(body.mesh.triangles[t]);
      const auto &all     = Bernstein::exponents(field.degree);
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int i = 0; i < all.size(); ++i)
          {
            const auto     subtriangle = subtriangle_of(corners, k);
            const auto     position    = Bernstein::point_of(all[i]);
            const Point<2> point(position[0] * subtriangle[0] +
                                 position[1] * subtriangle[1] +
                                 position[2] * subtriangle[2]);
            const auto     weighted = field.coefficient(t, k, i);
            if (body.is_on_axis(point))
              enlarge(errors.on_axis,
                      weighted.norm() / std::sqrt(area(corners)));
            else if (body.is_axisymmetric())
              enlarge(errors.circumferential,
                      std::abs(field.at(t, k, position)[2][2] / point[0] -
                               circumferential_at(field, t, k, position)));
            if (body.kinematics == Kinematics::plane_stress)
              enlarge(errors.out_of_plane, std::abs(weighted[2][2]));
            if (!HenckyMaterial::hardens(body.materials[t]))
              enlarge(errors.yield_excess,
                      inverse_weight(body, point) * deviator(weighted).norm() -
                        body.materials[t].yield_radius);
          }
    }



    /// Of a side at the boundary, where the pressure of body forces counts.
    void
    check_given_tractions(StressErrors                    &errors,
                          const PlaneBody                 &body,
                          const StressField               &field,
                          const unsigned int               s,
                          const std::vector<Tensor<1, 2>> &tractions)
    {
      const SplitMesh::Side &side = body.mesh.sides[s];
      look_along_side(
        body.mesh.vertices[side.vertices[0]],
        body.mesh.vertices[side.vertices[1]],
        [&](const double t, const Point<2> &x) {
          if (body.is_on_axis(x))
            return;
          const auto functions = Bernstein::side_functions(field.degree, t);
          const Tensor<1, 2> traction =
            inverse_weight(body, x) * std::inner_product(functions.begin(),
                                                         functions.end(),
                                                         tractions.begin(),
                                                         Tensor<1, 2>()) -
            body.pressure_of_body_force(x, field.load_factor) *
              body.mesh.normal(side);
          for (const auto &component : body.conditions[s].components)
            if (component.type == SideConditionType::traction)
              enlarge(errors.boundary_force,
                      std::abs(traction * component.direction -
                               component.value(x) -
                               field.load_factor * component.growth(x)));
        });
    }



    /// The coefficient of the pressure of the body forces, multiplied by the
    /// weight: both are linear along a side.
    double
    weighted_pressure(const PlaneBody   &body,
                      const StressField &field,
                      const unsigned int s,
                      const unsigned int coefficient)
    {
      const auto product = [&](const unsigned int i, const unsigned int j) {
        return body.weight(point_on_side(body, s, i, 1)) *
               body.pressure_of_body_force(point_on_side(body, s, j, 1),
                                           field.load_factor);
      };
      const unsigned int i = coefficient == field.degree;
      const unsigned int j = coefficient > 0;
      return 0.5 * (product(i, j) + product(j, i));
    }



    /// That no coefficient of the pressure of the indenter is a tension.
    /// @return its force.
    double
    check_indenter(StressErrors                    &errors,
                   const PlaneBody                 &body,
                   const StressField               &field,
                   const unsigned int               s,
                   const std::vector<Tensor<1, 2>> &tractions)
    {
      const auto &contact = body.conditions[s].components[1];
      if (contact.type != SideConditionType::contact)
        return 0.;
      const Tensor<1, 2> direction = contact.direction;
      const double cosine = body.mesh.normal(body.mesh.sides[s]) * direction;
      const double part =
        body.mesh.length(body.mesh.sides[s]) / (field.degree + 1.);
      double force = 0;
      for (unsigned int i = 0; i <= field.degree; ++i)
        {
          const double weighted = tractions[i] * direction -
                                  cosine * weighted_pressure(body, field, s, i);
          enlarge(errors.tension,
                  inverse_weight(body,
                                 point_on_side(body, s, i, field.degree)) *
                    weighted);
          force -= body.angle() * part * weighted * direction[1];
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
                     out_of_plane,
                     traction_jump,
                     boundary_force,
                     tension,
                     yield_excess,
                     force_difference});
  }



  StressErrors
  check_stress(const PlaneBody &body, const StressField &field)
  {
    StressErrors                           errors;
    double                                 force = 0;
    std::vector<std::vector<Tensor<1, 2>>> first(body.mesh.sides.size());
    std::vector<bool>                      seen(body.mesh.sides.size(), false);
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
              {
                check_given_tractions(errors, body, field, s, here);
                force += check_indenter(errors, body, field, s, here);
              }
            else if (!seen[s])
              first[s] = here;
            else
              for (unsigned int i = 0; i <= field.degree; ++i)
                enlarge(errors.traction_jump,
                        inverse_weight(
                          body, point_on_side(body, s, i, field.degree)) *
                          (here[i] - first[s][i]).norm());
            seen[s] = true;
          }
      }

    for (double *error : {&errors.divergence,
                          &errors.on_axis,
                          &errors.circumferential,
                          &errors.out_of_plane,
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
