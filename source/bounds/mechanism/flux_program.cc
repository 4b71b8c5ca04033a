// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/sparse_matrix.h>

#include <utility>
#include <vector>

#include "bounds/body/yield_matrices.h"
#include "bounds/conic/dissipation_block.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/sparse_cholesky.h"
#include "bounds/mechanism/velocity_basis.h"
#include "bounds/mechanism/velocity_program.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The linear velocities on tetrahedra whose unknowns are the normal
    /// components at the corners of their faces, continuous, and zero on closed
    /// faces: the element of Brezzi, Douglas and Marini in space
    /// @cite nedelec_1986. Where faces meet in a corner v, the velocity follows
    /// from those of the three: the function of face k is 1 there in the
    /// direction of normal(), and zero on the other two faces and at the other
    /// corners.
    VelocityBasis<3>
    flux_basis(const SplitBody<3> &body)
    {
      VelocityBasis<3>          basis;
      std::vector<unsigned int> first_numbers; // of faces
      for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
        {
          first_numbers.push_back(basis.size);
          basis.size += body.support_of(f).is_closed ? 0 : 3;
        }
      for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
        {
          const Corners<3>      corners   = body.corners_of(t);
          const auto            by_corner = gradients(corners);
          VelocityFunctions<3> &functions = basis.on_simplices.emplace_back();
          for (unsigned int k = 0; k < 4; ++k)
            {
              const unsigned int f = body.mesh.simplices[t].faces[k];
              if (body.support_of(f).is_closed)
                continue;
              const double across =
                by_corner[k] * normal(body.corners_of_face(f));
              for (unsigned int i = 0; i < 3; ++i)
                {
                  const unsigned int v = corner_of_face<3>(k, i);
                  const auto velocity  = across * (corners[k] - corners[v]);
                  functions.push_back(
                    {first_numbers[f] + i,
                     interpolate_velocity<3>([&](const Barycentric<3> &point) {
                       return point[v] * velocity;
                     })});
                }
            }
        }
      return basis;
    }



    /// The rate of a function, which is constant.
    SymmetricTensor<2, 3>
    rate_of(const SplitBody<3>        &body,
            const VelocityFunction<3> &function,
            const unsigned int         t)
    {
      return polynomial_rate<3>(body.corners_of(t),
                                function.velocity,
                                corner_position<3>(0));
    }



    // Of stresses, the deviator is limited and does the work; the mean stress
    // is not, and asks for velocities that change no volume.
    ConicBlock
    block_of_tetrahedron(const SplitBody<3>         &body,
                         const VelocityFunctions<3> &functions,
                         const unsigned int          t)
    {
      const Material<double>  &material = body.materials[t];
      const FullMatrix<double> deviator = rate_matrix<3>(material);
      const unsigned int       n        = deviator.m();
      const double       size = body.relative_volume(t) * body.length_unit;
      FullMatrix<double> rates(n + 1, functions.size());
      std::vector<unsigned int> equations;
      for (unsigned int f = 0; f < functions.size(); ++f)
        {
          const auto rate = rate_of(body, functions[f], t);
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int c = 0; c < deviator.n(); ++c)
              rates(i, f) += deviator(i, c) * rate.access_raw_entry(c);
          rates(n, f) = trace(rate);
          equations.push_back(functions[f].number);
        }
      DissipationBlock block(equations.size());
      block.add_norm(
        rates, 0, n, size, material.yield_radius / body.stress_unit);
      block.require_zero(rates, n, size);
      return block.make(equations);
    }



    /// Removes the divergence by the smallest change of the @p fluxes, the
    /// factors of the functions.
    // The change is -D^T (D D^T)^-1 D, with a row of D for the flux out of each
    // tetrahedron; to repeat that removes rounding errors.
    void
    remove_divergence(Vector<double>         &fluxes,
                      const SplitBody<3>     &body,
                      const VelocityBasis<3> &basis)
    {
      constexpr unsigned int n_repetitions = 3;

      const unsigned int                     n = basis.on_simplices.size();
      std::vector<std::vector<unsigned int>> simplices_of(basis.size);
      for (unsigned int t = 0; t < n; ++t)
        for (const auto &function : basis.on_simplices[t])
          simplices_of[function.number].push_back(t);
      SparsityPattern pattern;
      pattern.copy_from(basis.size,
                        n,
                        simplices_of.begin(),
                        simplices_of.end());
      SparseMatrix<double> transpose(pattern);
      for (unsigned int t = 0; t < n; ++t)
        for (const auto &function : basis.on_simplices[t])
          transpose.set(function.number,
                        t,
                        volume(body.corners_of(t)) *
                          trace(rate_of(body, function, t)));

      SparseCholesky factor(n, simplices_of);
      factor.clear();
      for (unsigned int i = 0; i < basis.size; ++i)
        for (const unsigned int t : simplices_of[i])
          for (const unsigned int u : simplices_of[i])
            if (u <= t)
              factor.entry(t, u) += transpose(i, t) * transpose(i, u);
      if (!factor.factorize())
        return; // what is left will be noticed
      Vector<double> flux(n), potential(n);
      for (unsigned int i = 0; i < n_repetitions; ++i)
        {
          transpose.Tvmult(flux, fluxes);
          factor.vmult(potential, flux);
          potential *= -1.;
          transpose.vmult_add(fluxes, potential);
        }
    }
  } // namespace



  VelocityField<3>
  find_flux(const SplitBody<3>        &body,
            const double               tolerance,
            const std::vector<double> &expected_multipliers)
  {
    const VelocityBasis<3> basis   = flux_basis(body);
    ConicProgram           program = program_of_loads(body, basis);
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      program.blocks.push_back(
        block_of_tetrahedron(body, basis.on_simplices[t], t));
    add_faces(program, body, basis, /* degree = */ 1);
    program.expect_multipliers(expected_multipliers);
    ConicSolution solution = minimize(std::move(program), tolerance);
    remove_divergence(solution.y, body, basis);
    return field_of(body, basis, solution);
  }
} // namespace ElastoPlastic
