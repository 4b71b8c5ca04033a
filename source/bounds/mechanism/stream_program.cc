// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/body/yield_matrices.h"
#include "bounds/conic/dissipation_block.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/face_view.h"
#include "bounds/mechanism/stream_element.h"
#include "bounds/mechanism/stream_unknowns.h"
#include "bounds/mechanism/velocity_program.h"

namespace ElastoPlastic
{
  namespace
  {
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
                          return std::abs(entry) > Tolerance::on_axis * largest;
                        }))
          rows.push_back(i);
      return rows;
    }



    /// Each of two neighbours pays for how it slides along their side, which
    /// has a velocity of its own: that adds up to what both pay with the
    /// smaller of their yield stresses.
    class StreamFunctionProgram
    {
    public:
      explicit StreamFunctionProgram(const SplitBody<2> &body)
        : body(body)
        , unknowns(body)
        , work_unit(body.stress_unit * body.length_unit * body.weight_unit())
      {
        program.right_hand_side.reinit(unknowns.size());
        if (body.load_factor_unit > 0)
          program.live_load.reinit(unknowns.size());
        for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
          add_block(t);
      }

      VelocityField<2>
      solve(const double tolerance) const
      {
        const ConicSolution solution = minimize(program, tolerance);
        VelocityField<2>    field;
        field.bound        = -solution.cost * (body.load_factor_unit > 0 ?
                                                 body.load_factor_unit :
                                                 body.angle() * work_unit);
        field.n_iterations = solution.n_iterations;
        field.is_optimal   = solution.is_optimal;
        for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
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

    private:
      void
      add_block(const unsigned int t)
      {
        const StreamElement element(body, t, unknowns.has_flux(t));
        const auto          equations = unknowns.on_triangle(t);
        DissipationBlock    block(equations.size());

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
      add_slip(DissipationBlock    &block,
               const StreamElement &element,
               const unsigned int   t,
               const unsigned int   k) const
      {
        const unsigned int   s         = body.mesh.simplices[t].faces[k];
        const auto          &side      = body.mesh.faces[s];
        const FaceSupport<2> support   = body.support_of(s);
        const bool           is_inside = side.is_inside();
        if (!is_inside && !support.resists_slip)
          return;

        const Tensor<1, 2> tangent = tangents(body.mesh.corners(side))[0];
        const auto slips   = is_inside ? element.slips_on_side(k, tangent) :
                                         element.velocities_on_side(k, tangent);
        const auto weights = element.weights_on_side(k);
        for (const unsigned int i : non_zero_rows(slips))
          block.add_norm(slips,
                         i,
                         1,
                         area(body.mesh.corners(side)) / slips.m() *
                           body.stress_unit / work_unit,
                         std::sqrt(0.5) * body.materials[t].yield_radius /
                           body.stress_unit * slip_factor(body, s, t)(0, 0),
                         weights[i] * (support.velocity * tangent));
      }

      void
      add_indenter(DissipationBlock    &block,
                   const StreamElement &element,
                   const unsigned int   t,
                   const unsigned int   k) const
      {
        const unsigned int s = body.mesh.simplices[t].faces[k];
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
                                (body.support_of(s).velocity * direction));
      }

      // Their power, for each of the local functions. Inside the body, nothing
      // is left of the pressure of body forces, because the normal velocity is
      // continuous; nor where it is zero.
      void
      add_loads(const StreamElement             &element,
                const std::vector<unsigned int> &equations,
                const unsigned int               t,
                const unsigned int               k)
      {
        const unsigned int s = body.mesh.simplices[t].faces[k];
        const FaceView<2>  view(body, s);
        if (view.face.is_inside())
          return;
        for (unsigned int c = 0; c < 2; ++c)
          if (view.condition.components[c].type != ConditionType::displacement)
            integrate_on_face<2>(
              view.corners,
              [&](const FacePoint<2> &point, const double weight) {
                const auto velocities =
                  element.weighted_velocities(view.point(point.position));
                for (unsigned int f = 0; f < velocities.size(); ++f)
                  if (equations[f] != numbers::invalid_unsigned_int)
                    {
                      const double velocity =
                        weight * view.area / work_unit *
                        (velocities[f] *
                         view.condition.components[c].direction);
                      program.right_hand_side[equations[f]] +=
                        velocity * body.load(s, c, point);
                      if (body.load_factor_unit > 0)
                        program.live_load[equations[f]] +=
                          velocity * body.load_factor_unit *
                          body.live_load(s, c, point);
                    }
              });
      }

      const SplitBody<2>  &body;
      const StreamUnknowns unknowns;
      const double         work_unit;
      ConicProgram         program;
    };
  } // namespace



  VelocityField<2>
  find_stream(const SplitBody<2> &body, const double tolerance)
  {
    return StreamFunctionProgram(body).solve(tolerance);
  }
} // namespace ElastoPlastic
