// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/exceptions.h"
#include "base/largest_error.h"
#include "base/text.h"
#include "bounds/conic/tolerances.h"
#include "bounds/error/support_check.h"

namespace ElastoPlastic
{
  namespace
  {
    /// How far a @p function on a side is from the polynomial of a degree with
    /// which it agrees at the points of Bernstein's basis.
    template <typename Function>
    double
    distance_to_polynomial(const FaceCorners<2> &corners,
                           const unsigned int    degree,
                           const Function       &function)
    {
      const auto polynomial =
        Bernstein<1>::interpolate(degree, [&](const Barycentric<1> &position) {
          return function(point_on_face<2>(corners, position));
        });
      double largest = 0;
      look_over_face<2>(corners, [&](const FacePoint<2> &point) {
        keep_largest(largest,
                     std::abs(function(point) -
                              Bernstein<1>::value(degree,
                                                  polynomial.begin(),
                                                  point.position)));
      });
      return largest;
    }



    [[noreturn]] void
    reject_tractions(const SplitBody<2> &body,
                     const unsigned int  side,
                     const unsigned int  degree)
    {
      const auto ends = body.corners_of_face(side);
      const bool is_heavy =
        body.body_force.norm() + body.live_body_force.norm() > 0.;
      throw InputError(
        "The tractions of 'Boundary conditions/Traction'" +
        std::string(is_heavy ? ", and the pressure of 'Body force'," : "") +
        " do not fit stresses of the equilibrium method on the side of the "
        "mesh from (" +
        Patterns::Tools::to_string(ends[0]) + ") to (" +
        Patterns::Tools::to_string(ends[1]) +
        "): there they must be polynomials of degree " +
        std::to_string(degree) +
        (body.is_axisymmetric() ? " when multiplied by r" : "") +
        ". Put jumps and kinks on vertices of the mesh ('Geometry')" +
        (degree == 1 ? "; limit loads under quadratic ones can be found with "
                       "'Limit load/Stresses = quadratic'." :
                       "."));
    }



    void
    require_polynomials(const SplitBody<2> &body,
                        const unsigned int  degree,
                        double TwoLoads::*const load)
    {
      double       largest = 0, largest_distance = 0;
      unsigned int worst_side = 0;
      for (unsigned int s = 0; s < body.mesh.faces.size(); ++s)
        for (unsigned int c = 0; c < 2; ++c)
          if (body.conditions[s].components[c].type == ConditionType::traction)
            {
              const auto weighted_load = [&](const FacePoint<2> &point) {
                const double weighted =
                  body.weight(point.x) * (body.loads(s, c, point).*load);
                keep_largest(largest, std::abs(weighted));
                return weighted;
              };
              const double distance =
                distance_to_polynomial(body.corners_of_face(s),
                                       degree,
                                       weighted_load);
              if (distance > largest_distance)
                worst_side = s;
              keep_largest(largest_distance, distance);
            }
      if (largest_distance > Tolerance::traction * largest)
        reject_tractions(body, worst_side, degree);
    }
  } // namespace



  void
  require_quadratic_supports(const SplitBody<2> &body)
  {
    for (unsigned int s = 0; s < body.mesh.faces.size(); ++s)
      for (const auto &component : body.conditions[s].components)
        if (component.type == ConditionType::displacement)
          {
            const auto corners = body.corners_of_face(s);
            double     largest = 0;
            const auto value   = [&](const FacePoint<2> &point) {
              keep_largest(largest, std::abs(component.value(point)));
              return component.value(point);
            };
            if (distance_to_polynomial(corners, 2, value) >
                Tolerance::expression * largest)
              throw InputError(
                "A displacement of 'Boundary conditions/Prescribed "
                "displacement' "
                "is not quadratic on the sides of the mesh, near the point (" +
                Patterns::Tools::to_string(
                  Point<2>(0.5 * (corners[0] + corners[1]))) +
                "). An error bound is for displacements that are polynomials "
                "of degree 2 or less of x and y. Prescribe such, or choose "
                "'Analysis = contact'.");
          }
  }



  void
  require_polynomial_tractions(const SplitBody<2> &body,
                               const unsigned int  degree)
  {
    require_polynomials(body, degree, &TwoLoads::constant);
    require_polynomials(body, degree, &TwoLoads::growing);
  }



  // What they differ by may be rounding errors of the largest displacement.
  template <int dim>
  void
  require_supported(const SplitBody<dim>      &body,
                    const QuadraticField<dim> &displacement)
  {
    double largest_displacement = 0, largest_difference = 0;
    for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
      for (const auto &component : body.conditions[f].components)
        if (component.type == ConditionType::displacement)
          {
            const auto v = displacement.values_on_face(body.mesh, f);
            look_over_face<dim>(
              body.corners_of_face(f), [&](const FacePoint<dim> &point) {
                const double along =
                  v.value(point.position) * component.direction;
                keep_largest(largest_displacement, std::abs(along));
                keep_largest(largest_difference,
                             std::abs(along - component.value(point)));
              });
          }
    for (const auto &v : displacement.at_vertices)
      keep_largest(largest_displacement, v.norm());
    if (!(largest_difference <=
          Tolerance::admissibility * largest_displacement))
      throw ConvergenceError(
        "The displacement differs from what the supports prescribe by " +
        to_text(largest_difference) + ". " +
        (dim == 2 ?
           "The equilibrium method needs straight rollers, boundaries whose "
           "prescribed displacements agree where they meet, and cells that are "
           "parallelograms or quadratic elements where a prescribed "
           "displacement depends on the position." :
           "In space, the equilibrium method needs flat rollers, and cells "
           "whose faces are parallelograms where a prescribed displacement "
           "depends on the position."));
  }



  template void
  require_supported(const SplitBody<2> &, const QuadraticField<2> &);
  template void
  require_supported(const SplitBody<3> &, const QuadraticField<3> &);
} // namespace ElastoPlastic
