// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/body/side_support.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/power_block.h"
#include "bounds/mechanism/stream_element.h"
#include "bounds/mechanism/stream_program.h"
#include "bounds/mechanism/stream_unknowns.h"
#include "bounds/mesh/integration.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr double work_tolerance = 1e-6;

    /// Relative to the largest of their kind: coefficients that vanish on the
    /// axis.
    constexpr double relative_zero = 1e-12;

    /// Coefficients that do not vanish on the axis.
    std::vector<unsigned int>
    non_zero_rows(const FullMatrix<double> &matrix)
    {
      std::vector<unsigned int> rows;
      const double              largest = matrix.linfty_norm();
      for (unsigned int i = 0; i < matrix.m(); ++i)
        if (std::any_of(&matrix(i, 0),
                        &matrix(i, 0) + matrix.n(),
                        [&](const double entry) {
                          return std::abs(entry) > relative_zero * largest;
                        }))
          rows.push_back(i);
      return rows;
    }



    /// Each of two neighbours pays for how it slides along their side, which
    /// has a velocity of its own: that adds up to what both pay with the
    /// smaller of their yield stresses.
    class StreamProgram
    {
    public:
      explicit StreamProgram(const PlaneBody &body);

      VelocityField
      solve() const;

    private:
      void
      add_block(const unsigned int triangle);
      void
      add_slip(PowerBlock          &block,
               const StreamElement &element,
               const unsigned int   triangle,
               const unsigned int   k) const;
      void
      add_indenter(PowerBlock          &block,
                   const StreamElement &element,
                   const unsigned int   triangle,
                   const unsigned int   k) const;
      void
      add_loads(const StreamElement             &element,
                const std::vector<unsigned int> &equations,
                const unsigned int               triangle,
                const unsigned int               k);

      const PlaneBody     &body;
      const StreamUnknowns unknowns;
      const double         work_unit;
      ConicProgram         program;
    };



    StreamProgram::StreamProgram(const PlaneBody &body)
      : body(body)
      , unknowns(body)
      , work_unit(body.stress_unit * body.length_unit * body.weight_unit())
    {
      program.right_hand_side.reinit(unknowns.size());
      if (body.load_factor_unit > 0)
        program.growth.reinit(unknowns.size());
      for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
        add_block(t);
    }



    void
    StreamProgram::add_block(const unsigned int t)
    {
      const StreamElement element(body, t, unknowns.has_flux(t));
      const auto          equations = unknowns.on_triangle(t);
      PowerBlock          block(equations.size());

      const auto [rates, weights] = element.rates();
      const unsigned int n        = element.n_rate_components();
      for (unsigned int p = 0; p < weights.size(); ++p)
        block.add_norm(rates,
                       n * p,
                       n,
                       weights[p] * body.stress_unit / work_unit,
                       body.materials[t].yield_radius / body.stress_unit);
      for (unsigned int k = 0; k < 3; ++k)
        {
          add_slip(block, element, t, k);
          add_indenter(block, element, t, k);
          add_loads(element, equations, t, k);
        }
      program.blocks.push_back(block.make(equations));
    }



    void
    StreamProgram::add_slip(PowerBlock          &block,
                            const StreamElement &element,
                            const unsigned int   t,
                            const unsigned int   k) const
    {
      const unsigned int s       = body.mesh.triangles[t].sides[k];
      const auto        &side    = body.mesh.sides[s];
      const SideSupport  support = support_of(body, s);
      const bool         is_inside =
        side.boundary_id == numbers::internal_face_boundary_id;
      if (!is_inside && !support.resists_slip)
        return;

      const Tensor<1, 2> tangent = -cross_product_2d(body.mesh.normal(side));
      const auto         slips = is_inside ? element.slips_on_side(k, tangent) :
                                             element.velocities_on_side(k, tangent);
      const auto         weights = element.weights_on_side(k);
      for (const unsigned int i : non_zero_rows(slips))
        block.add_norm(slips,
                       i,
                       1,
                       body.mesh.length(side) / slips.m() * body.stress_unit /
                         work_unit,
                       std::sqrt(0.5) * body.materials[t].yield_radius /
                         body.stress_unit,
                       weights[i] * (support.velocity * tangent));
    }



    void
    StreamProgram::add_indenter(PowerBlock          &block,
                                const StreamElement &element,
                                const unsigned int   t,
                                const unsigned int   k) const
    {
      const unsigned int s = body.mesh.triangles[t].sides[k];
      if (!body.conditions[s].is_reached)
        return;
      const auto &direction  = body.conditions[s].components[1].direction;
      const auto  velocities = element.velocities_on_side(k, direction);
      const auto  weights    = element.weights_on_side(k);
      for (const unsigned int i : non_zero_rows(velocities))
        block.add_condition(velocities,
                            i,
                            1. / body.weight_unit(),
                            weights[i] *
                              (support_of(body, s).velocity * direction));
    }



    // Their power, for each of the local functions. Inside the body, nothing is
    // left of the pressure of body forces, because the normal velocity is
    // continuous; nor where it is zero.
    void
    StreamProgram::add_loads(const StreamElement             &element,
                             const std::vector<unsigned int> &equations,
                             const unsigned int               t,
                             const unsigned int               k)
    {
      const auto        &triangle = body.mesh.triangles[t];
      const auto         corners  = body.mesh.corners(triangle);
      const unsigned int next     = (k + 1) % 3;
      const double       length   = corners[k].distance(corners[next]);
      const unsigned int s        = triangle.sides[k];
      const Tensor<1, 2> normal   = body.mesh.normal(body.mesh.sides[s]);
      for (const auto &component : body.conditions[s].components)
        if (component.type == SideConditionType::traction ||
            component.type == SideConditionType::contact)
          integrate_on_side(
            corners[k],
            corners[next],
            [&](const double position, const Point<2> &x, const double weight) {
              Bernstein::Barycentric point = {};
              point[k]                     = 1. - position;
              point[next]                  = position;
              const auto velocities        = element.weighted_velocities(point);
              for (unsigned int f = 0; f < velocities.size(); ++f)
                if (equations[f] != numbers::invalid_unsigned_int)
                  {
                    const double velocity =
                      weight * length / work_unit *
                      (velocities[f] * component.direction);
                    program.right_hand_side[equations[f]] +=
                      velocity * body.load(component, normal, x);
                    if (body.load_factor_unit > 0)
                      program.growth[equations[f]] +=
                        velocity * body.load_factor_unit *
                        body.growth(component, normal, x);
                  }
            });
    }



    VelocityField
    StreamProgram::solve() const
    {
      const ConicSolution solution = minimize(program, work_tolerance);
      VelocityField       field;
      field.bound =
        -solution.cost * (body.load_factor_unit > 0 ? body.load_factor_unit :
                                                      body.angle() * work_unit);
      field.n_iterations = solution.n_iterations;
      field.is_optimal   = solution.is_optimal;
      for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
        {
          const StreamElement element(body, t, unknowns.has_flux(t));
          const auto          equations = unknowns.on_triangle(t);
          Vector<double>      coefficients(element.n_functions());
          for (unsigned int f = 0; f < coefficients.size(); ++f)
            if (equations[f] != numbers::invalid_unsigned_int)
              coefficients[f] = -solution.y[equations[f]];
          field.velocity.push_back(element.velocity(coefficients));
        }
      return field;
    }
  } // namespace



  VelocityField
  find_stream(const PlaneBody &body)
  {
    return StreamProgram(body).solve();
  }
} // namespace ElastoPlastic
