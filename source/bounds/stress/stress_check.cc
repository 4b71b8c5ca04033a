// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/exceptions.h"
#include "base/largest_error.h"
#include "base/tensors.h"
#include "base/text.h"
#include "bounds/body/hencky_material.h"
#include "bounds/body/yield_norms.h"
#include "bounds/conic/tolerances.h"
#include "bounds/stress/johnson_mercier.h"
#include "bounds/stress/stress_check.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    double
    size_of_simplex(const Corners<dim> &corners)
    {
      return std::pow(volume(corners), 1. / dim);
    }



    /// Keeps the largest errors of a field.
    template <int dim>
    class StressCheck
    {
    public:
      StressCheck(const SplitBody<dim> &body, const StressField<dim> &field)
        : body(body)
        , field(field)
      {}

      /// That S has the divergence that the circumferential stress asks for.
      void
      check_equilibrium(const unsigned int t)
      {
        const auto   corners = body.corners_of(t);
        const double size    = size_of_simplex<dim>(corners);
        for (unsigned int k = 0; k < Element::n_parts; ++k)
          {
            const auto part    = Element::part_of(corners, k);
            auto       missing = divergence(part, t, k);
            for (unsigned int i = 0; i < missing.size(); ++i)
              {
                if (body.is_axisymmetric())
                  missing[i][0] -=
                    field.circumferential[t][missing.size() * k + i];
                keep_largest(errors.divergence,
                             size * missing[i].norm() /
                               body.weight(part[place_of_centre<dim>(k)]));
              }
          }
      }

      /// That the tractions are continuous between the parts k and l.
      void
      check_between_parts(const unsigned int t,
                          const unsigned int k,
                          const unsigned int l)
      {
        const auto part          = Element::part_of(body.corners_of(t), k);
        const auto [here, there] = Element::places_between(k, l);
        FaceCorners<dim> corners;
        for (unsigned int j = 0; j < dim; ++j)
          corners[j] = part[here[j]];
        const Tensor<1, dim> n = normal(corners);
        for (unsigned int i = 0; i < Element::n_face_points(field.degree); ++i)
          {
            const auto jump = in_plane<dim>(
              field.coefficient(
                t, k, Element::number_on_face(field.degree, here, i)) -
              field.coefficient(
                t, l, Element::number_on_face(field.degree, there, i)));
            keep_largest(errors.traction_jump,
                         inverse_weight(corners, i) * (jump * n).norm());
          }
      }

      /// The yield condition, which holds everywhere if it does for the
      /// coefficients over those of the weight, and what makes it hold for the
      /// circumferential stress and on the axis.
      void
      check_points(const unsigned int t)
      {
        const auto  corners   = body.corners_of(t);
        const auto &points    = Bernstein<dim>::points(field.degree);
        const auto &exponents = Bernstein<dim>::exponents(field.degree);
        for (unsigned int k = 0; k < Element::n_parts; ++k)
          {
            const auto part = Element::part_of(corners, k);
            for (unsigned int i = 0; i < points.size(); ++i)
              {
                const Point<dim> x        = interpolate(points[i], part);
                const auto       weighted = field.coefficient(t, k, i);
                if (body.is_on_axis(x))
                  keep_largest(errors.on_axis,
                               weighted.norm() / size_of_simplex<dim>(corners));
                else if (body.is_axisymmetric())
                  keep_largest(errors.circumferential,
                               std::abs(field.at(t, k, points[i])[2][2] / x[0] -
                                        circumferential_at(t, k, points[i])));
                if (body.kinematics == Kinematics::plane_stress)
                  keep_largest(errors.out_of_plane, std::abs(weighted[2][2]));
                if (!HenckyMaterial::hardens(body.materials[t]))
                  check_strength(t,
                                 inverse_weight(x) *
                                   (weighted -
                                    weighted_pressure(part, exponents[i]) *
                                      unit_symmetric_tensor<3>()));
              }
          }
      }

      /// @return the force of the indenter.
      double
      check_face(const unsigned int f)
      {
        const auto          &face   = body.mesh.faces[f];
        const Tensor<1, dim> normal = body.outward_normal(f);
        const auto           of     = [&](const unsigned int i) {
          const unsigned int t = face.neighbors[i];
          return field.tractions(body.mesh,
                                 t,
                                 body.mesh.simplices[t].place_of_face(f),
                                 normal);
        };
        const auto here = of(0);
        if (face.is_inside())
          {
            const auto there = of(1);
            for (unsigned int i = 0; i < here.size(); ++i)
              keep_largest(errors.traction_jump,
                           inverse_weight(body.corners_of_face(f), i) *
                             (there[i] - here[i]).norm());
            return 0.;
          }
        check_given_tractions(f, normal, here);
        return body.conditions[f].is_pressed() ?
                 check_indenter(f, normal, here) :
                 0.;
      }

      StressErrors errors;

    private:
      using Element = JohnsonMercier<dim>;

      /// 1 / weight off the axis, 0 on it.
      double
      inverse_weight(const Point<dim> &x) const
      {
        return body.is_on_axis(x) ? 0. : 1. / body.weight(x);
      }

      /// That of the point that coefficient @p i on a face belongs to.
      double
      inverse_weight(const FaceCorners<dim> &corners,
                     const unsigned int      i) const
      {
        return inverse_weight(
          point_on_face<dim>(corners,
                             Bernstein<dim - 1>::points(field.degree)[i])
            .x);
      }

      /// The yield condition of a stress, relative to what the material bears:
      /// under tension, without it, as the strength of soil ends at its apex.
      void
      check_strength(const unsigned int t, const SymmetricTensor<2, 3> &stress)
      {
        const double radius = body.yield_radius(t, stress),
                     excess = stress_norm(body.materials[t], stress) - radius;
        if (!(excess <= 0.))
          keep_largest(errors.yield_excess,
                       excess /
                         std::max(radius, body.materials[t].yield_radius));
      }

      /// The coefficients of the divergence of the weighted stress on a part
      /// with these @p corners, by differences between those of the stress on
      /// the ways from its first corner.
      std::vector<Tensor<1, dim>>
      divergence(const Corners<dim> &corners,
                 const unsigned int  t,
                 const unsigned int  part) const
      {
        Tensor<2, dim> ways;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            ways[i][d] = corners[i + 1][d] - corners[0][d];
        const Tensor<2, dim>        inverse = invert(ways);
        std::vector<Tensor<1, dim>> result;
        for (const auto &exponents :
             Bernstein<dim>::exponents(field.degree - 1))
          {
            const auto beside = [&](const unsigned int corner) {
              return in_plane<dim>(field.coefficient(
                t,
                part,
                Bernstein<dim>::number_of(
                  Bernstein<dim>::raised(exponents, corner))));
            };
            Tensor<1, dim> sum;
            for (unsigned int i = 0; i < dim; ++i)
              {
                const auto change = beside(i + 1) - beside(0);
                for (unsigned int d = 0; d < dim; ++d)
                  sum += 1. * field.degree * inverse[d][i] *
                         (change * Point<dim>::unit_vector(d));
              }
            result.push_back(sum);
          }
        return result;
      }

      /// The circumferential stress at a @p point of a part.
      double
      circumferential_at(const unsigned int      t,
                         const unsigned int      k,
                         const Barycentric<dim> &point) const
      {
        const unsigned int degree = field.degree - 1;
        return Bernstein<dim>::value(degree,
                                     field.circumferential[t].begin() +
                                       Bernstein<dim>::n_functions(degree) * k,
                                     point);
      }

      /// A coefficient of the pressure of the body forces, multiplied by the
      /// weight: both are linear on a face or a part with these @p corners.
      /// With the degree 1, their product counts where it is at the corners.
      template <std::size_t n>
      double
      weighted_pressure(const std::array<Point<dim>, n> &corners,
                        const std::array<int, n>        &exponents) const
      {
        const auto product = [&](const unsigned int i, const unsigned int j) {
          return body.weight(corners[i]) *
                 body.pressure_of_body_force(corners[j], field.load_factor);
        };
        std::vector<unsigned int> factors; // corners, as often as they count
        for (unsigned int i = 0; i < n; ++i)
          factors.insert(factors.end(), exponents[i], i);
        return 0.5 * (product(factors.front(), factors.back()) +
                      product(factors.back(), factors.front()));
      }

      /// Of a face at the boundary, where the pressure of body forces counts.
      void
      check_given_tractions(const unsigned int                 f,
                            const Tensor<1, dim>              &normal,
                            const std::vector<Tensor<1, dim>> &tractions)
      {
        look_over_face<dim>(
          body.corners_of_face(f), [&](const FacePoint<dim> &point) {
            if (body.is_on_axis(point.x))
              return;
            const Tensor<1, dim> traction =
              inverse_weight(point.x) *
                Bernstein<dim - 1>::value(field.degree,
                                          tractions.begin(),
                                          point.position) -
              body.pressure_of_body_force(point.x, field.load_factor) * normal;
            for (const auto &component : body.conditions[f].components)
              if (component.type == ConditionType::traction)
                keep_largest(errors.boundary_force,
                             std::abs(traction * component.direction -
                                      component.value(point) -
                                      field.load_factor *
                                        component.live_load(point)));
          });
      }

      /// That no coefficient of the pressure of the indenter is a tension.
      /// @return its force.
      double
      check_indenter(const unsigned int                 f,
                     const Tensor<1, dim>              &normal,
                     const std::vector<Tensor<1, dim>> &tractions)
      {
        const Tensor<1, dim> direction = body.conditions[f].contact().direction;
        const auto           corners   = body.corners_of_face(f);
        const auto  &exponents = Bernstein<dim - 1>::exponents(field.degree);
        const double cosine    = normal * direction;
        double       force     = 0;
        for (unsigned int i = 0; i < tractions.size(); ++i)
          {
            const double weighted =
              tractions[i] * direction -
              cosine * weighted_pressure(corners, exponents[i]);
            keep_largest(errors.tension, inverse_weight(corners, i) * weighted);
            force -= body.angle() * area(corners) / tractions.size() *
                     weighted * direction[dim - 1];
          }
        return force;
      }

      const SplitBody<dim>   &body;
      const StressField<dim> &field;
    };
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



  template <int dim>
  StressErrors
  check_stress(const SplitBody<dim> &body, const StressField<dim> &field)
  {
    StressCheck<dim> check(body, field);
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      {
        check.check_equilibrium(t);
        for (unsigned int k = 0; k < JohnsonMercier<dim>::n_parts; ++k)
          for (unsigned int l = k + 1; l < JohnsonMercier<dim>::n_parts; ++l)
            check.check_between_parts(t, k, l);
        check.check_points(t);
      }
    double force = 0;
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      force += check.check_face(f);

    StressErrors &errors = check.errors;
    for (double *error : {&errors.divergence,
                          &errors.on_axis,
                          &errors.circumferential,
                          &errors.out_of_plane,
                          &errors.traction_jump,
                          &errors.boundary_force,
                          &errors.tension})
      *error /= body.stress_unit;
    errors.force_difference = std::abs(force - field.force) /
                              std::max(std::abs(force), body.force_unit());
    return errors;
  }



  template <int dim>
  double
  require_admissible(const SplitBody<dim> &body, const StressField<dim> &field)
  {
    const double error = check_stress(body, field).largest();
    if (error > Tolerance::admissibility)
      throw ConvergenceError(
        "The stresses of the equilibrium method violate equilibrium or yield "
        "condition by " +
        to_text(error) +
        " of the strength of the material. If this is more than rounding, look "
        "at the "
        "tractions: on each side of a triangle, or face of a tetrahedron, they "
        "must be polynomials of the degree of the stresses, in a body of "
        "revolution when multiplied by r.");
    return error;
  }



  template StressErrors
  check_stress(const SplitBody<2> &, const StressField<2> &);
  template StressErrors
  check_stress(const SplitBody<3> &, const StressField<3> &);
  template double
  require_admissible(const SplitBody<2> &, const StressField<2> &);
  template double
  require_admissible(const SplitBody<3> &, const StressField<3> &);
} // namespace ElastoPlastic
