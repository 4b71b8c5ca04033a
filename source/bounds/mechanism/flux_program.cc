// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <utility>
#include <vector>

#include "bounds/body/yield_matrices.h"
#include "bounds/conic/dissipation_block.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/sparse_cholesky.h"
#include "bounds/mechanism/face_view.h"
#include "bounds/mechanism/velocity_program.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The linear velocities on a tetrahedron whose unknowns are the normal
    /// components at the corners of its faces: the element of Brezzi, Douglas
    /// and Marini in space @cite nedelec_1986. Where faces meet in a corner,
    /// the velocity follows from those of the three.
    class FluxElement
    {
    public:
      FluxElement(const SplitBody<3> &body, const unsigned int t)
        : corners(body.mesh.corners(body.mesh.simplices[t]))
        , gradients_of_corners(gradients(corners))
      {
        for (unsigned int k = 0; k < 4; ++k)
          normal_derivatives[k] =
            gradients_of_corners[k] *
            normal(body.mesh.corners(
              body.mesh.faces[body.mesh.simplices[t].faces[k]]));
      }

      /// At corner @p v, of the function whose normal component on face @p k is
      /// 1 there, in the direction of normal(), and zero on the other two
      /// faces. At the other corners, it vanishes.
      Tensor<1, 3>
      velocity(const unsigned int k, const unsigned int v) const
      {
        return normal_derivatives[k] * (corners[k] - corners[v]);
      }

      /// Its strain rate, which is constant.
      SymmetricTensor<2, 3>
      rate(const unsigned int k, const unsigned int v) const
      {
        return symmetrize(
          outer_product(velocity(k, v), gradients_of_corners[v]));
      }

      const Corners<3> corners;

    private:
      const std::array<Tensor<1, 3>, 4> gradients_of_corners;
      std::array<double, 4>             normal_derivatives;
    };



    /// The unknowns of such velocities, whose normal components are continuous,
    /// and zero on closed faces.
    class FluxUnknowns
    {
    public:
      /// @p body must live as long as this object.
      explicit FluxUnknowns(const SplitBody<3> &body)
        : body(body)
      {
        for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
          {
            const bool is_closed = body.support_of(f).is_closed;
            for (unsigned int i = 0; i < 3; ++i)
              numbering.push_back(is_closed ? numbers::invalid_unsigned_int :
                                              n_unknowns++);
          }
      }

      unsigned int
      size() const
      {
        return n_unknowns;
      }

      /// That of face @p k of a tetrahedron at its corner @p v;
      /// invalid_unsigned_int if it vanishes.
      unsigned int
      at(const unsigned int tetrahedron,
         const unsigned int k,
         const unsigned int v) const
      {
        return numbering[3 * body.mesh.simplices[tetrahedron].faces[k] +
                         (v < k ? v : v - 1)];
      }

      /// Calls @p action(k, v, unknown) for those of a tetrahedron.
      template <typename Action>
      void
      for_each(const unsigned int tetrahedron, const Action &action) const
      {
        for (unsigned int k = 0; k < 4; ++k)
          for (unsigned int v = 0; v < 4; ++v)
            if (v != k &&
                at(tetrahedron, k, v) != numbers::invalid_unsigned_int)
              action(k, v, at(tetrahedron, k, v));
      }

      /// Removes the divergence by the smallest change of the @p fluxes.
      // The change is -D^T (D D^T)^-1 D, with a row of D for the flux out of
      // each tetrahedron; to repeat that removes rounding errors.
      void
      remove_divergence(Vector<double> &fluxes) const
      {
        constexpr unsigned int n_repetitions = 3;

        const unsigned int     n = body.mesh.simplices.size();
        DynamicSparsityPattern couplings(n, n_unknowns), neighbors(n, n);
        for (unsigned int t = 0; t < n; ++t)
          for_each(t,
                   [&](unsigned int, unsigned int, const unsigned int unknown) {
                     couplings.add(t, unknown);
                   });
        for (const auto &face : body.mesh.faces)
          for (const unsigned int s : face.neighbors)
            for (const unsigned int t : face.neighbors)
              if (s != numbers::invalid_unsigned_int &&
                  t != numbers::invalid_unsigned_int)
                neighbors.add(s, t);
        SparsityPattern pattern, pattern_of_square;
        pattern.copy_from(couplings);
        pattern_of_square.copy_from(neighbors);

        SparseMatrix<double> divergence(pattern), square(pattern_of_square);
        for (unsigned int t = 0; t < n; ++t)
          {
            const FluxElement element(body, t);
            for_each(t, [&](const auto k, const auto v, const auto unknown) {
              divergence.set(t,
                             unknown,
                             volume(element.corners) *
                               trace(element.rate(k, v)));
            });
          }
        for (unsigned int t = 0; t < n; ++t)
          for (auto entry = square.begin(t); entry != square.end(t); ++entry)
            for (auto d = divergence.begin(t); d != divergence.end(t); ++d)
              entry->value() +=
                d->value() * divergence.el(entry->column(), d->column());

        SparseCholesky factor(pattern_of_square);
        if (!factor.factorize(square))
          return; // what is left will be noticed
        Vector<double> flux(n), potential(n);
        for (unsigned int i = 0; i < n_repetitions; ++i)
          {
            divergence.vmult(flux, fluxes);
            factor.vmult(potential, flux);
            potential *= -1.;
            divergence.Tvmult_add(fluxes, potential);
          }
      }

    private:
      const SplitBody<3>       &body;
      std::vector<unsigned int> numbering; ///< by faces and their corners
      unsigned int              n_unknowns = 0;
    };



    /// In the units of the body, as the dual of a DissipationBlock's.
    class FluxProgram
    {
    public:
      explicit FluxProgram(const SplitBody<3> &body)
        : body(body)
        , unknowns(body)
      {
        program.set_equations(unknowns.size(), body.load_factor_unit > 0);
        for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
          add_work(t);
        for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
          {
            for (unsigned int i = 0; i < 3; ++i)
              {
                if (FaceView<3>(body, f).resists_slip())
                  add_slip(f, i);
                if (body.conditions[f].is_reached)
                  add_indenter(f, i);
              }
            if (!body.mesh.faces[f].is_inside())
              add_loads(f);
          }
      }

      /// Can be called once.
      VelocityField<3>
      solve(const double tolerance)
      {
        const ConicSolution solution = minimize(std::move(program), tolerance);
        VelocityField<3>    field    = field_of(body, solution);
        Vector<double>      fluxes   = solution.y;
        fluxes *= -1.;
        unknowns.remove_divergence(fluxes);
        for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
          {
            const FluxElement           element(body, t);
            std::array<Tensor<1, 3>, 4> at_corners;
            unknowns.for_each(t, [&](const auto k, const auto v, const auto i) {
              at_corners[v] += fluxes[i] * element.velocity(k, v);
            });
            field.velocity.push_back(
              interpolate_velocity<3>([&](const Barycentric<3> &point) {
                return interpolate(point, at_corners);
              }));
          }
        return field;
      }

    private:
      // Of stresses, the deviator is limited and does the work; the mean stress
      // is not, and asks for velocities that change no volume.
      void
      add_work(const unsigned int t)
      {
        const FullMatrix<double> deviator = rate_matrix<3>(body.materials[t]);
        const unsigned int       n        = deviator.m();

        ConicBlock &block = program.blocks.emplace_back(n + 1);
        block.cone_matrix.reinit(n + 1, n + 1);
        block.cone_offset.reinit(n + 1);
        block.cone_offset[0] =
          body.materials[t].yield_radius / body.stress_unit;
        for (unsigned int i = 0; i < n; ++i)
          block.cone_matrix(1 + i, i) = -1.;
        block.cone_sizes = {n + 1};
        block.cone_scales.resize(1);

        const FluxElement element(body, t);
        const double      weight =
          volume(element.corners) / (body.length_unit * body.length_unit);
        Vector<double> powers(n + 1);
        unknowns.for_each(t,
                          [&](const auto k, const auto v, const auto unknown) {
                            const SymmetricTensor<2, 3> rate =
                              element.rate(k, v);
                            for (unsigned int i = 0; i < n; ++i)
                              {
                                powers[i] = 0;
                                for (unsigned int c = 0; c < deviator.n(); ++c)
                                  powers[i] += weight * deviator(i, c) *
                                               rate.access_raw_entry(c);
                              }
                            powers[n] = weight * trace(rate);
                            block.add_to_equation(unknown, powers);
                          });
      }

      void
      add_slip(const unsigned int f, const unsigned int corner)
      {
        const auto directions = tangents(body.mesh.corners(body.mesh.faces[f]));
        const unsigned int n_neighbors = body.mesh.faces[f].n_neighbors();
        FullMatrix<double> slips(2, 3 * n_neighbors);
        std::vector<unsigned int> equations;
        for (unsigned int n = 0; n < n_neighbors; ++n)
          {
            const Trace at_corner = trace_at(f, n, corner);
            for (unsigned int i = 0; i < 3; ++i)
              {
                equations.push_back(at_corner.unknowns[i]);
                for (unsigned int d = 0; d < 2; ++d)
                  slips(d, 3 * n + i) =
                    (n == 0 ? 1. : -1.) *
                    (at_corner.velocities[i] * directions[d]);
              }
          }
        FullMatrix<double> work(slips.m(), slips.n());
        slip_factor(body, f).mmult(work, slips);
        DissipationBlock block(slips.n());
        block.add_norm(work,
                       0,
                       2,
                       body.relative_area(f) / 3.,
                       body.shear_strength(f) / body.stress_unit);
        program.blocks.push_back(block.make(equations));
      }

      void
      add_indenter(const unsigned int f, const unsigned int corner)
      {
        const Trace        at_corner = trace_at(f, 0, corner);
        FullMatrix<double> vertical(1, 3);
        for (unsigned int i = 0; i < 3; ++i)
          vertical(0, i) = at_corner.velocities[i][2];
        DissipationBlock block(3);
        block.add_condition(vertical,
                            0,
                            body.relative_area(f) / 3.,
                            body.indenter_velocity[2]);
        program.blocks.push_back(
          block.make(std::vector<unsigned int>(at_corner.unknowns.begin(),
                                               at_corner.unknowns.end())));
      }

      // Velocities and loads are linear on the face. Where the body is held,
      // they do no work.
      void
      add_loads(const unsigned int f)
      {
        std::array<FacePoint<3>, 3> points;
        for (unsigned int i = 0; i < 3; ++i)
          points[i] = corner_point<3>(body.corners_of_face(f), i);
        for (unsigned int i = 0; i < 3; ++i)
          {
            const Trace at_corner = trace_at(f, 0, i);
            for (unsigned int c = 0; c < 3; ++c)
              for (unsigned int k = 0; k < 3; ++k)
                {
                  const auto &component      = body.conditions[f].components[c];
                  const unsigned int unknown = at_corner.unknowns[k];
                  if (component.type == ConditionType::displacement ||
                      unknown == numbers::invalid_unsigned_int)
                    continue;
                  const double along =
                    body.relative_area(f) / 3. / body.stress_unit *
                    (at_corner.velocities[k] * component.direction);
                  for (unsigned int j = 0; j < 3; ++j)
                    {
                      const double part = (i == j ? 0.5 : 0.25) * along;
                      const auto [constant, growing] =
                        body.loads(f, c, points[j]);
                      program.add_load(unknown,
                                       part * constant,
                                       part * body.load_factor_unit * growing);
                    }
                }
          }
      }

      /// The three velocities of a neighbour of a face that do not vanish at
      /// one of its corners, and their unknowns.
      struct Trace
      {
        std::array<Tensor<1, 3>, 3> velocities;
        std::array<unsigned int, 3> unknowns;
      };

      Trace
      trace_at(const unsigned int f,
               const unsigned int neighbor,
               const unsigned int corner) const
      {
        const unsigned int t = body.mesh.faces[f].neighbors[neighbor];
        const FluxElement  element(body, t);
        const unsigned int v = body.mesh.simplices[t].place_of_vertex(
          body.mesh.faces[f].vertices[corner]);
        Trace result;
        for (unsigned int i = 0; i < 3; ++i)
          {
            const unsigned int k = corner_of_face<3>(v, i);
            result.velocities[i] = element.velocity(k, v);
            result.unknowns[i]   = unknowns.at(t, k, v);
          }
        return result;
      }

      const SplitBody<3> &body;
      const FluxUnknowns  unknowns;
      ConicProgram        program;
    };
  } // namespace



  VelocityField<3>
  find_flux(const SplitBody<3> &body, const double tolerance)
  {
    return FluxProgram(body).solve(tolerance);
  }
} // namespace ElastoPlastic
