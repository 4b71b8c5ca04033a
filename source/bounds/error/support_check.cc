// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/exceptions.h"
#include "base/largest_error.h"
#include "base/to_text.h"
#include "bounds/error/support_check.h"
#include "bounds/mesh/integration.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The differences between a displacement and what the supports prescribe,
    /// which may be rounding errors of the largest displacement there.
    struct Differences
    {
      double largest_displacement = 0;
      double largest              = 0;

      void
      add(const double displacement, const double prescribed)
      {
        enlarge(largest_displacement, std::abs(displacement));
        enlarge(largest, std::abs(displacement - prescribed));
      }

      /// @throws ConvergenceError
      void
      require_rounding_errors(const std::string &what_is_needed) const
      {
        constexpr double rounding = 1e-8;
        if (!(largest <= rounding * largest_displacement))
          throw ConvergenceError(
            "The displacement differs from what the supports prescribe by " +
            to_text(largest) + ". " + what_is_needed);
      }
    };



    /// The quadratic function with these values at the ends and in the middle.
    double
    quadratic(const double t,
              const double begin,
              const double end,
              const double middle)
    {
      return (1. - t) * (1. - 2. * t) * begin + t * (2. * t - 1.) * end +
             4. * t * (1. - t) * middle;
    }



    /// Calls @p action(component, a, b) for what is prescribed on the side
    /// number @p s from a to b.
    template <typename Action>
    void
    for_each_support(const PlaneBody   &body,
                     const unsigned int s,
                     const Action      &action)
    {
      const auto &ends = body.mesh.sides[s].vertices;
      for (const auto &component : body.conditions[s].components)
        if (component.type == SideConditionType::displacement)
          action(component,
                 body.mesh.vertices[ends[0]],
                 body.mesh.vertices[ends[1]]);
    }



    /// How far a @p load on the side from @p a to @p b is from the polynomial
    /// of the @p degree 1 or 2 with which it agrees at the ends and, if it can,
    /// in the middle.
    template <typename Load>
    double
    distance_to_polynomial(const Point<2>    &a,
                           const Point<2>    &b,
                           const unsigned int degree,
                           const Load        &load)
    {
      const double begin = load(a), end = load(b),
                   middle = degree == 1 ? 0.5 * (begin + end) :
                                          load(Point<2>(0.5 * (a + b)));
      double largest      = 0;
      look_along_side(a, b, [&](const double t, const Point<2> &x) {
        enlarge(largest, std::abs(load(x) - quadratic(t, begin, end, middle)));
      });
      return largest;
    }



    [[noreturn]] void
    reject_tractions(const PlaneBody   &body,
                     const unsigned int side,
                     const unsigned int degree)
    {
      const auto &ends = body.mesh.sides[side].vertices;
      const bool  is_heavy =
        body.body_force.norm() + body.body_force_growth.norm() > 0.;
      throw InputError(
        "The tractions of 'Boundary conditions/Traction'" +
        std::string(is_heavy ? ", and the pressure of 'Body force'," : "") +
        " do not fit stresses of the equilibrium method on the side of the "
        "mesh from (" +
        Patterns::Tools::to_string(body.mesh.vertices[ends[0]]) + ") to (" +
        Patterns::Tools::to_string(body.mesh.vertices[ends[1]]) +
        "): there they must be polynomials of degree " +
        std::to_string(degree) +
        (body.is_axisymmetric() ? " when multiplied by r" : "") +
        ". Put jumps and kinks on vertices of the mesh ('Geometry')" +
        (degree == 1 ? "; limit loads under quadratic ones can be found with "
                       "'Limit load/Stresses = quadratic'." :
                       "."));
    }



    /// One of the loads of a PlaneBody, load() or growth().
    using LoadOnSide = double (PlaneBody::*)(const SideCondition::Component &,
                                             const Tensor<1, 2> &,
                                             const Point<2> &) const;



    void
    require_polynomials(const PlaneBody   &body,
                        const unsigned int degree,
                        const LoadOnSide   load_on_side)
    {
      constexpr double rounding = 1e-6;

      double       largest = 0, largest_distance = 0;
      unsigned int worst_side = 0;
      for (unsigned int s = 0; s < body.mesh.sides.size(); ++s)
        for (const auto &component : body.conditions[s].components)
          if (component.type == SideConditionType::traction)
            {
              const auto        &ends   = body.mesh.sides[s].vertices;
              const Tensor<1, 2> normal = body.mesh.normal(body.mesh.sides[s]);
              const auto         weighted_load = [&](const Point<2> &x) {
                const double load =
                  body.weight(x) * (body.*load_on_side)(component, normal, x);
                enlarge(largest, std::abs(load));
                return load;
              };
              const double distance =
                distance_to_polynomial(body.mesh.vertices[ends[0]],
                                       body.mesh.vertices[ends[1]],
                                       degree,
                                       weighted_load);
              if (distance > largest_distance)
                worst_side = s;
              enlarge(largest_distance, distance);
            }
      if (largest_distance > rounding * largest)
        reject_tractions(body, worst_side, degree);
    }
  } // namespace



  void
  require_quadratic_supports(const PlaneBody &body)
  {
    constexpr double rounding = 1e-9;

    for (unsigned int s = 0; s < body.mesh.sides.size(); ++s)
      for_each_support(
        body,
        s,
        [](const auto &component, const Point<2> &a, const Point<2> &b) {
          const double begin = component.value(a), end = component.value(b),
                       middle = component.value(Point<2>(0.5 * (a + b)));
          double largest = 0, difference = 0;
          look_along_side(a, b, [&](const double t, const Point<2> &x) {
            const double value = component.value(x);
            largest            = std::max(largest, std::abs(value));
            enlarge(difference,
                    std::abs(value - quadratic(t, begin, end, middle)));
          });
          if (difference > rounding * largest)
            throw InputError(
              "A displacement of 'Boundary conditions/Prescribed displacement' "
              "is not quadratic on the sides of the mesh, near the point (" +
              Patterns::Tools::to_string(Point<2>(0.5 * (a + b))) +
              "). An error bound is for displacements that are polynomials of "
              "degree 2 or less of x and y. Prescribe such, or choose "
              "'Analysis = contact'.");
        });
  }



  void
  require_polynomial_tractions(const PlaneBody &body, const unsigned int degree)
  {
    require_polynomials(body, degree, &PlaneBody::load);
    require_polynomials(body, degree, &PlaneBody::growth);
  }



  void
  require_supported(const PlaneBody &body, const QuadraticField &displacement)
  {
    Differences differences;
    for (unsigned int s = 0; s < body.mesh.sides.size(); ++s)
      for_each_support(
        body,
        s,
        [&](const auto &component, const Point<2> &a, const Point<2> &b) {
          const auto  &ends  = body.mesh.sides[s].vertices;
          const double begin = displacement.at_vertices[ends[0]] *
                               component.direction,
                       end = displacement.at_vertices[ends[1]] *
                             component.direction,
                       middle = displacement.at_sides[s] * component.direction;
          look_along_side(a, b, [&](const double t, const Point<2> &x) {
            differences.add(quadratic(t, begin, end, middle),
                            component.value(x));
          });
        });
    for (const auto &v : displacement.at_vertices)
      enlarge(differences.largest_displacement, v.norm());
    differences.require_rounding_errors(
      "The equilibrium method needs straight rollers, boundaries whose "
      "prescribed displacements agree where they meet, and cells that are "
      "parallelograms or quadratic elements where a prescribed displacement "
      "depends on the position.");
  }



  void
  require_supported(const SpaceBody           &body,
                    const SpaceQuadraticField &displacement)
  {
    Differences differences;
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      for (const auto &component : body.conditions[f].components)
        if (component.type == SideConditionType::displacement)
          {
            const FaceValues v = values_on_face(body.mesh, displacement, f);
            const auto      &u = component.values;
            for (unsigned int i = 0; i < 3; ++i)
              {
                differences.add(v.at_corners[i] * component.direction, u[i]);
                differences.add(v.at_edges[i] * component.direction,
                                0.5 * (u[i] + u[(i + 1) % 3]));
              }
          }
    for (const auto &v : displacement.at_vertices)
      enlarge(differences.largest_displacement, v.norm());
    differences.require_rounding_errors(
      "In space, the equilibrium method needs flat rollers, and cells "
      "whose faces are parallelograms where a prescribed displacement "
      "depends on the position.");
  }
} // namespace ElastoPlastic
