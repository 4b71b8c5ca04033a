// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include "equilibrium/interior_point.h"
#include "equilibrium/power_block.h"
#include "equilibrium/space_velocity.h"
#include "equilibrium/sparse_cholesky.h"
#include "equilibrium/tetrahedron_stress.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Of the gap between the work and its lower bound in the space of these
    /// velocities, relative.
    constexpr double space_work_tolerance = 1e-5;



    /// The velocities of a tetrahedron that belong to the unknowns: the normal
    /// components at the corners of its faces.
    class FluxElement
    {
    public:
      FluxElement(const SpaceBody &body, const unsigned int t)
        : faces(body.mesh.tetrahedra[t].faces)
        , corners(body.mesh.corners(body.mesh.tetrahedra[t]))
        , gradients(ElastoPlastic::gradients(corners))
      {
        for (unsigned int k = 0; k < 4; ++k)
          normal_derivatives[k] =
            gradients[k] * normal(body.mesh.corners(body.mesh.faces[faces[k]]));
      }

      /// Where the normal component on face @p k at corner @p v is 1, and those
      /// of the other two faces there are zero.
      Tensor<1, 3>
      velocity(const unsigned int k, const unsigned int v) const
      {
        return normal_derivatives[k] * (corners[k] - corners[v]);
      }

      SymmetricTensor<2, 3>
      rate(const unsigned int k, const unsigned int v) const
      {
        return symmetrize(outer_product(velocity(k, v), gradients[v]));
      }

      const std::array<unsigned int, 4> faces;
      const Tetrahedron                 corners;

    private:
      const std::array<Tensor<1, 3>, 4> gradients;
      std::array<double, 4>             normal_derivatives;
    };



    /// In the units of the body, as the dual of a PowerBlock's.
    class SpaceVelocityProgram
    {
    public:
      explicit SpaceVelocityProgram(const SpaceBody &body);

      SpaceVelocityField
      solve() const;

    private:
      void
      number_unknowns();
      void
      add_work(const unsigned int tetrahedron);
      void
      add_slip(const unsigned int face, const unsigned int corner);
      void
      add_indenter(const unsigned int face, const unsigned int corner);
      void
      add_tractions(const unsigned int face);

      /// The three velocities of a neighbour of a face that do not vanish at
      /// one of its corners, and their unknowns.
      struct Trace
      {
        std::array<Tensor<1, 3>, 3> velocities;
        std::array<unsigned int, 3> unknowns;
      };

      Trace
      trace_at(const unsigned int face,
               const unsigned int neighbor,
               const unsigned int corner) const;

      /// The unknown of face @p k of a tetrahedron at its corner @p v.
      unsigned int
      unknown(const unsigned int tetrahedron,
              const unsigned int k,
              const unsigned int v) const
      {
        return unknowns[body.index(body.mesh.tetrahedra[tetrahedron].faces[k],
                                   v < k ? v : v - 1)];
      }

      void
      remove_divergence(Vector<double> &fluxes) const;

      const SpaceBody          &body;
      std::vector<unsigned int> unknowns; ///< see SpaceBody::index()
      unsigned int              n_unknowns = 0;
      ConicProgram              program;
    };



    SpaceVelocityProgram::SpaceVelocityProgram(const SpaceBody &body)
      : body(body)
    {
      number_unknowns();
      program.right_hand_side.reinit(n_unknowns);
      for (unsigned int t = 0; t < body.mesh.tetrahedra.size(); ++t)
        add_work(t);
      for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
        {
          for (unsigned int i = 0; i < 3; ++i)
            {
              if (slip_takes_work(body, f))
                add_slip(f, i);
              if (body.conditions[f].is_reached)
                add_indenter(f, i);
            }
          if (!body.mesh.faces[f].is_inside())
            add_tractions(f);
        }
    }



    void
    SpaceVelocityProgram::number_unknowns()
    {
      for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
        for (unsigned int i = 0; i < 3; ++i)
          unknowns.push_back(body.support_of(f).is_closed ?
                               numbers::invalid_unsigned_int :
                               n_unknowns++);
    }



    // Of stresses, the deviator is limited and does the work; the mean stress
    // is not, and asks for velocities that change no volume.
    void
    SpaceVelocityProgram::add_work(const unsigned int t)
    {
      static const FullMatrix<double> deviator =
        TetrahedronStress::deviator_matrix();
      const unsigned int n = deviator.m();

      ConicBlock &block = program.blocks.emplace_back(n + 1);
      block.cone_matrix.reinit(n + 1, n + 1);
      block.cone_offset.reinit(n + 1);
      block.cone_offset[0] = body.materials[t].yield_radius / body.stress_unit;
      for (unsigned int i = 0; i < n; ++i)
        block.cone_matrix(1 + i, i) = -1.;
      block.cone_sizes = {n + 1};
      block.cone_scales.resize(1);

      const FluxElement element(body, t);
      const double      weight =
        volume(element.corners) / (body.length_unit * body.length_unit);
      Vector<double> powers(n + 1);
      for (unsigned int k = 0; k < 4; ++k)
        for (unsigned int v = 0; v < 4; ++v)
          if (v != k && unknown(t, k, v) != numbers::invalid_unsigned_int)
            {
              const SymmetricTensor<2, 3> rate = element.rate(k, v);
              for (unsigned int i = 0; i < n; ++i)
                {
                  powers[i] = 0;
                  for (unsigned int c = 0; c < deviator.n(); ++c)
                    powers[i] +=
                      weight * deviator(i, c) * rate.access_raw_entry(c);
                }
              powers[n] = weight * trace(rate);
              block.add_to_equation(unknown(t, k, v), powers);
            }
    }



    SpaceVelocityProgram::Trace
    SpaceVelocityProgram::trace_at(const unsigned int f,
                                   const unsigned int neighbor,
                                   const unsigned int corner) const
    {
      const unsigned int t = body.mesh.faces[f].neighbors[neighbor];
      const FluxElement  element(body, t);
      unsigned int       v = 0;
      while (body.mesh.tetrahedra[t].vertices[v] !=
             body.mesh.faces[f].vertices[corner])
        ++v;
      Trace result;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int k = corner_of_face(v, i);
          result.velocities[i] = element.velocity(k, v);
          result.unknowns[i]   = unknown(t, k, v);
        }
      return result;
    }



    void
    SpaceVelocityProgram::add_slip(const unsigned int f,
                                   const unsigned int corner)
    {
      const auto directions = tangents(body.mesh.corners(body.mesh.faces[f]));
      const unsigned int n_neighbors = body.mesh.faces[f].is_inside() ? 2 : 1;
      FullMatrix<double> slips(2, 3 * n_neighbors);
      std::vector<unsigned int> equations;
      for (unsigned int n = 0; n < n_neighbors; ++n)
        {
          const Trace at_corner = trace_at(f, n, corner);
          for (unsigned int i = 0; i < 3; ++i)
            {
              equations.push_back(at_corner.unknowns[i]);
              for (unsigned int d = 0; d < 2; ++d)
                slips(d, 3 * n + i) = (n == 0 ? 1. : -1.) *
                                      (at_corner.velocities[i] * directions[d]);
            }
        }
      PowerBlock block(slips.n());
      block.add_norm(slips,
                     0,
                     2,
                     body.area_of_corner(f),
                     body.shear_strength(f) / body.stress_unit);
      program.blocks.push_back(block.make(equations));
    }



    void
    SpaceVelocityProgram::add_indenter(const unsigned int f,
                                       const unsigned int corner)
    {
      const Trace        at_corner = trace_at(f, 0, corner);
      FullMatrix<double> vertical(1, 3);
      for (unsigned int i = 0; i < 3; ++i)
        vertical(0, i) = at_corner.velocities[i][2];
      PowerBlock block(3);
      block.add_condition(vertical, 0, body.area_of_corner(f), -1.);
      program.blocks.push_back(
        block.make(std::vector<unsigned int>(at_corner.unknowns.begin(),
                                             at_corner.unknowns.end())));
    }



    // Velocities and tractions are linear on the face.
    void
    SpaceVelocityProgram::add_tractions(const unsigned int f)
    {
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Trace at_corner = trace_at(f, 0, i);
          for (const auto &component : body.conditions[f].components)
            for (unsigned int j = 0; j < 3; ++j)
              for (unsigned int k = 0; k < 3; ++k)
                if (at_corner.unknowns[k] != numbers::invalid_unsigned_int)
                  program.right_hand_side[at_corner.unknowns[k]] +=
                    body.area_of_corner(f) * (i == j ? 0.5 : 0.25) *
                    component.tractions[j] / body.stress_unit *
                    (at_corner.velocities[k] * component.direction);
        }
    }



    // The least change of the unknowns that does so: D^T (D D^T)^-1 D, with a
    // row of D for the flux out of each tetrahedron.
    void
    SpaceVelocityProgram::remove_divergence(Vector<double> &fluxes) const
    {
      const auto            &tetrahedra = body.mesh.tetrahedra;
      DynamicSparsityPattern couplings(tetrahedra.size(), n_unknowns);
      for (unsigned int t = 0; t < tetrahedra.size(); ++t)
        for (unsigned int k = 0; k < 4; ++k)
          for (unsigned int v = 0; v < 4; ++v)
            if (v != k && unknown(t, k, v) != numbers::invalid_unsigned_int)
              couplings.add(t, unknown(t, k, v));
      SparsityPattern pattern, pattern_of_square;
      pattern.copy_from(couplings);
      SparseMatrix<double> divergence(pattern), square;
      for (unsigned int t = 0; t < tetrahedra.size(); ++t)
        {
          const FluxElement element(body, t);
          for (unsigned int k = 0; k < 4; ++k)
            for (unsigned int v = 0; v < 4; ++v)
              if (v != k && unknown(t, k, v) != numbers::invalid_unsigned_int)
                divergence.set(t,
                               unknown(t, k, v),
                               volume(element.corners) *
                                 trace(element.rate(k, v)));
        }
      DynamicSparsityPattern neighbors(tetrahedra.size(), tetrahedra.size());
      for (unsigned int t = 0; t < tetrahedra.size(); ++t)
        neighbors.add(t, t);
      for (const auto &face : body.mesh.faces)
        if (face.is_inside())
          {
            neighbors.add(face.neighbors[0], face.neighbors[1]);
            neighbors.add(face.neighbors[1], face.neighbors[0]);
          }
      pattern_of_square.copy_from(neighbors);
      square.reinit(pattern_of_square);
      for (unsigned int t = 0; t < tetrahedra.size(); ++t)
        for (auto entry = square.begin(t); entry != square.end(t); ++entry)
          for (auto d = divergence.begin(t); d != divergence.end(t); ++d)
            entry->value() +=
              d->value() * divergence.el(entry->column(), d->column());

      SparseCholesky factor(pattern_of_square);
      if (!factor.factorize(square))
        return;
      Vector<double> flux(tetrahedra.size()), potential(tetrahedra.size());
      for (unsigned int repetition = 0; repetition < 3; ++repetition)
        {
          divergence.vmult(flux, fluxes);
          factor.vmult(potential, flux);
          potential *= -1.;
          divergence.Tvmult_add(fluxes, potential);
        }
    }



    SpaceVelocityField
    SpaceVelocityProgram::solve() const
    {
      const ConicSolution solution = minimize(program, space_work_tolerance);
      SpaceVelocityField  field;
      field.force =
        -solution.cost * body.stress_unit * body.length_unit * body.length_unit;
      field.n_iterations = solution.n_iterations;
      field.is_optimal   = solution.is_optimal;

      Vector<double> fluxes = solution.y;
      fluxes *= -1.;
      remove_divergence(fluxes);
      for (unsigned int t = 0; t < body.mesh.tetrahedra.size(); ++t)
        {
          const FluxElement element(body, t);
          CornerVelocities &velocity = field.velocity.emplace_back();
          for (unsigned int v = 0; v < 4; ++v)
            for (unsigned int k = 0; k < 4; ++k)
              if (k != v && unknown(t, k, v) != numbers::invalid_unsigned_int)
                velocity[v] +=
                  fluxes[unknown(t, k, v)] * element.velocity(k, v);
        }
      return field;
    }
  } // namespace



  SpaceVelocityField
  find_motion_in_space(const SpaceBody &body)
  {
    return SpaceVelocityProgram(body).solve();
  }
} // namespace ElastoPlastic
