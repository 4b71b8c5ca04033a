// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "bounds/body/yield_matrices.h"
#include "bounds/conic/dissipation_block.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/face_view.h"
#include "bounds/mechanism/stream_element.h"
#include "bounds/mechanism/velocity_program.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The unknowns of a mechanism with a stream function, numbered:
    /// coefficients of the cubic psi, in plane strain, or chi, those of the
    /// linear phi in a body of revolution (StreamElement), and three for the
    /// velocity along each side inside the body.
    ///
    /// They are continuous. Nothing moves through closed sides: the stream
    /// function is the same all along them. It vanishes on the axis, or else in
    /// the first vertex.
    class StreamUnknowns
    {
    public:
      /// @p body must live as long as this object.
      explicit StreamUnknowns(const SplitBody<2> &body)
        : body(body)
        , first_on_sides(body.mesh.vertices.size())
        , first_inside(first_on_sides + 2 * body.mesh.faces.size())
        , first_flux(first_inside + body.mesh.simplices.size())
        , first_velocity(first_flux + body.mesh.vertices.size())
        , zero(first_velocity + 3 * body.mesh.faces.size())
        , vertex_has_flux(body.mesh.vertices.size(), body.is_axisymmetric())
      {
        find_flux();
        number();
      }

      /// Of different unknowns that need not vanish.
      unsigned int
      size() const
      {
        return n_unknowns;
      }

      /// Whether there is a phi on a triangle. There is none in plane strain,
      /// nor where triangles touch the axis.
      bool
      has_flux(const unsigned int t) const
      {
        const auto &vertices = body.mesh.simplices[t].vertices;
        return std::any_of(vertices.begin(),
                           vertices.end(),
                           [this](const unsigned int v) {
                             return vertex_has_flux[v];
                           });
      }

      /// Those of the local functions of the StreamElement of a triangle, and
      /// of its sides' velocities; invalid_unsigned_int if they vanish.
      std::vector<unsigned int>
      on_triangle(const unsigned int t) const
      {
        const auto               &triangle = body.mesh.simplices[t];
        std::vector<unsigned int> unknowns(triangle.vertices.begin(),
                                           triangle.vertices.end());
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int i = 1; i < 3; ++i)
            unknowns.push_back(
              cubic(triangle.faces[k], triangle.vertices[k], i));
        unknowns.push_back(first_inside + t);
        if (has_flux(t))
          for (const unsigned int v : triangle.vertices)
            unknowns.push_back(first_flux + v);
        for (unsigned int k = 0; k < 3; ++k)
          {
            const unsigned int s = triangle.faces[k];
            const bool         same_direction =
              body.mesh.faces[s].vertices[0] == triangle.vertices[k];
            for (unsigned int i = 0; i < 3; ++i)
              unknowns.push_back(first_velocity + 3 * s +
                                 (same_direction ? i : 2 - i));
          }
        for (unsigned int &unknown : unknowns)
          unknown = numbering[unknown];
        return unknowns;
      }

    private:
      using Sets = boost::disjoint_sets_with_storage<>;

      void
      find_flux()
      {
        const auto is_on_axis = [this](const unsigned int v) {
          return body.is_on_axis(body.mesh.vertices[v]);
        };
        for (const auto &triangle : body.mesh.simplices)
          if (std::any_of(triangle.vertices.begin(),
                          triangle.vertices.end(),
                          is_on_axis))
            for (const unsigned int v : triangle.vertices)
              vertex_has_flux[v] = false;
      }

      // r^2 chi is constant along a side with chi if r is, and else only if it
      // vanishes.
      void
      close_side(Sets &sets, const unsigned int s) const
      {
        const auto    &vertices = body.mesh.faces[s].vertices;
        const Point<2> a        = body.mesh.vertices[vertices[0]],
                       b        = body.mesh.vertices[vertices[1]];
        if (body.is_on_axis(a) && body.is_on_axis(b))
          return;
        const bool varies = std::abs(body.weight(a) - body.weight(b)) >
                            Tolerance::on_axis * a.distance(b);
        for (unsigned int i = 0; i < 4; ++i)
          sets.union_set(cubic(s, vertices[0], i), varies ? zero : vertices[0]);
        sets.union_set(first_flux + vertices[0], first_flux + vertices[1]);
      }

      void
      number()
      {
        Sets sets(zero + 1);
        for (unsigned int s = 0; s < body.mesh.faces.size(); ++s)
          {
            if (body.support_of(s).is_closed)
              close_side(sets, s);
            if (!body.mesh.faces[s].is_inside())
              for (unsigned int i = 0; i < 3; ++i)
                sets.union_set(first_velocity + 3 * s + i, zero);
          }
        bool is_known = false;
        for (unsigned int v = 0; v < vertex_has_flux.size(); ++v)
          if (!vertex_has_flux[v])
            {
              sets.union_set(first_flux + v, zero);
              is_known = body.is_axisymmetric();
            }
        if (!is_known)
          sets.union_set(body.is_axisymmetric() ? first_flux : 0, zero);

        std::map<unsigned int, unsigned int> of_sets;
        for (unsigned int i = 0; i < zero; ++i)
          {
            const unsigned int set = sets.find_set(i);
            numbering.push_back(
              set == sets.find_set(zero) ?
                numbers::invalid_unsigned_int :
                of_sets.try_emplace(set, of_sets.size()).first->second);
          }
        n_unknowns = of_sets.size();
      }

      /// The coefficient on a side that is the @p i th (0 to 3) from an end on.
      unsigned int
      cubic(const unsigned int s,
            const unsigned int first_vertex,
            const unsigned int i) const
      {
        const auto        &vertices = body.mesh.faces[s].vertices;
        const unsigned int k        = vertices[0] == first_vertex ? i : 3 - i;
        return k == 0 ? vertices[0] :
               k == 3 ? vertices[1] :
                        first_on_sides + 2 * s + k - 1;
      }

      const SplitBody<2> &body;

      /// The first unknown of each kind, before they have been numbered; those
      /// of vertices come before all of these. The last is zero.
      const unsigned int first_on_sides, first_inside, first_flux,
        first_velocity, zero;

      std::vector<bool>         vertex_has_flux;
      std::vector<unsigned int> numbering;
      unsigned int              n_unknowns = 0;
    };



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
        program.set_equations(unknowns.size(), body.load_factor_unit > 0);
        for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
          add_block(t);
      }

      VelocityField<2>
      solve(const double tolerance) const
      {
        const ConicSolution solution = minimize(program, tolerance);
        VelocityField<2>    field    = field_of(body, solution);
        for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
          {
            const StreamElement element(body, t, unknowns.has_flux(t));
            const auto          equations = unknowns.on_triangle(t);
            auto               &velocity  = field.velocity.emplace_back();
            for (unsigned int f = 0; f < element.functions.size(); ++f)
              if (equations[f] != numbers::invalid_unsigned_int)
                velocity.add(-solution.y[equations[f]], element.functions[f]);
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
                const auto [constant, growing] = body.loads(s, c, point);
                for (unsigned int f = 0; f < element.functions.size(); ++f)
                  if (equations[f] != numbers::invalid_unsigned_int)
                    {
                      const double along =
                        weight * view.area / work_unit *
                        (weighted_velocity(body,
                                           element.functions[f],
                                           t,
                                           view.point(point.position)) *
                         view.condition.components[c].direction);
                      program.add_load(equations[f],
                                       along * constant,
                                       along * body.load_factor_unit * growing);
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
