// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "bounds/conic/dissipation_block.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/tolerances.h"
#include "bounds/mechanism/stream_element.h"
#include "bounds/mechanism/velocity_basis.h"
#include "bounds/mechanism/velocity_program.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The unknowns of a mechanism with a stream function, numbered:
    /// coefficients of the cubic psi, in plane strain, or chi, and those of the
    /// linear phi in a body of revolution (StreamElement).
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
        , zero(first_flux + body.mesh.vertices.size())
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

      /// Those of the local functions of the StreamElement of a triangle;
      /// invalid_unsigned_int if they vanish.
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
          if (body.support_of(s).is_closed)
            close_side(sets, s);
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
      const unsigned int first_on_sides, first_inside, first_flux, zero;

      std::vector<bool>         vertex_has_flux;
      std::vector<unsigned int> numbering;
      unsigned int              n_unknowns = 0;
    };



    /// What a triangle contributes to the plastic work, without its sides.
    ConicBlock
    block_of_triangle(const SplitBody<2>              &body,
                      const StreamElement             &element,
                      const std::vector<unsigned int> &equations,
                      const unsigned int               t)
    {
      DissipationBlock   block(equations.size());
      const auto         rates = element.rates();
      const unsigned int n     = element.n_rate_components();
      for (unsigned int p = 0; p < rates.weights.size(); ++p)
        block.add_norm(rates.rates,
                       n * p,
                       n,
                       rates.weights[p] /
                         (body.length_unit * body.weight_unit()),
                       body.materials[t].yield_radius / body.stress_unit);
      return block.make(equations);
    }
  } // namespace



  VelocityField<2>
  find_stream(const SplitBody<2>        &body,
              const double               tolerance,
              const std::vector<double> &expected_multipliers)
  {
    const StreamUnknowns    unknowns(body);
    VelocityBasis<2>        basis = {unknowns.size(), {}};
    std::vector<ConicBlock> blocks;
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      {
        const StreamElement element(body, t, unknowns.has_flux(t));
        const auto          equations = unknowns.on_triangle(t);
        blocks.push_back(block_of_triangle(body, element, equations, t));
        auto &functions = basis.on_simplices.emplace_back();
        for (unsigned int f = 0; f < equations.size(); ++f)
          if (equations[f] != numbers::invalid_unsigned_int)
            functions.push_back({equations[f], element.functions[f]});
      }
    ConicProgram program = program_of_loads(body, basis);
    program.blocks       = std::move(blocks);
    add_faces(program,
              body,
              basis,
              /* degree = */ body.is_axisymmetric() ? 4 : 2);
    program.expect_multipliers(expected_multipliers);
    return field_of(body, basis, minimize(std::move(program), tolerance));
  }
} // namespace ElastoPlastic
