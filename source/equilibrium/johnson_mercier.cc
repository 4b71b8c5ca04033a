// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include "equilibrium/integration.h"
#include "equilibrium/johnson_mercier.h"
#include "equilibrium/split_mesh.h"

namespace ElastoPlastic::JohnsonMercier
{
  namespace
  {
    /// Adds the traction of the stress at a corner of a subtriangle on a plane
    /// with this @p normal to two rows of @p matrix.
    void
    add_traction(FullMatrix<double> &matrix,
                 const unsigned int  row,
                 const unsigned int  subtriangle,
                 const unsigned int  corner,
                 const Tensor<1, 2> &normal)
    {
      matrix(row, value_index(subtriangle, corner, 0)) += normal[0];
      matrix(row, value_index(subtriangle, corner, 2)) += normal[1];
      matrix(row + 1, value_index(subtriangle, corner, 2)) += normal[0];
      matrix(row + 1, value_index(subtriangle, corner, 1)) += normal[1];
    }



    Tensor<1, 2>
    normal(const Point<2> &begin, const Point<2> &end)
    {
      return cross_product_2d(end - begin) / begin.distance(end);
    }



    /// The jumps of the tractions at both ends of the three lines between
    /// subtriangles (12 x 27). The line to corner k is side 1 of the
    /// subtriangle before and side 2 of subtriangle k.
    FullMatrix<double>
    jump_matrix(const Triangle &triangle)
    {
      FullMatrix<double> jumps(12, n_values);
      for (unsigned int k = 0; k < 3; ++k)
        {
          const Triangle     subtriangle = subtriangle_of(triangle, k);
          const Tensor<1, 2> n      = normal(subtriangle[0], subtriangle[2]);
          const unsigned int before = (k + 2) % 3;
          add_traction(jumps, 4 * k, k, 0, n);
          add_traction(jumps, 4 * k, before, 1, -n);
          add_traction(jumps, 4 * k + 2, k, 2, n);
          add_traction(jumps, 4 * k + 2, before, 2, -n);
        }
      return jumps;
    }



    /// The rows of @p matrix from row @p first on.
    void
    fill_rows(FullMatrix<double>       &matrix,
              const unsigned int        first,
              const FullMatrix<double> &rows)
    {
      matrix.fill(rows, first, 0, 0, 0);
    }



    // The right singular vectors that belong to the singular value zero.
    FullMatrix<double>
    reference_equilibrated_basis()
    {
      const Triangle     reference = {{Point<2>(0, 0), {1, 0}, {0, 1}}};
      FullMatrix<double> conditions(18, n_values);
      fill_rows(conditions, 0, jump_matrix(reference));
      fill_rows(conditions, 12, divergence_matrix(reference));

      LAPACKFullMatrix<double> decomposition(18, n_values);
      decomposition = conditions;
      decomposition.compute_svd();
      FullMatrix<double> basis(n_values, n_equilibrated_dofs);
      for (unsigned int i = 0; i < n_values; ++i)
        for (unsigned int j = 0; j < n_equilibrated_dofs; ++j)
          basis(i, j) = decomposition.get_svd_vt()(18 + j, i);
      return basis;
    }
  } // namespace



  Triangle
  subtriangle_of(const Triangle &triangle, const unsigned int subtriangle)
  {
    return {{triangle[subtriangle],
             triangle[(subtriangle + 1) % 3],
             Point<2>((triangle[0] + triangle[1] + triangle[2]) / 3.)}};
  }



  std::array<Tensor<1, 2>, 3>
  gradients(const Triangle &triangle)
  {
    std::array<Tensor<1, 2>, 3> result;
    for (unsigned int i = 0; i < 3; ++i)
      result[i] =
        -cross_product_2d(triangle[(i + 2) % 3] - triangle[(i + 1) % 3]) /
        (2. * area(triangle));
    return result;
  }



  SymmetricTensor<2, 2>
  stress_at(const Vector<double> &values,
            const unsigned int    subtriangle,
            const unsigned int    corner)
  {
    SymmetricTensor<2, 2> stress;
    stress[0][0] = values[value_index(subtriangle, corner, 0)];
    stress[1][1] = values[value_index(subtriangle, corner, 1)];
    stress[0][1] = values[value_index(subtriangle, corner, 2)];
    return stress;
  }



  FullMatrix<double>
  traction_matrix(const Triangle &triangle)
  {
    FullMatrix<double> tractions(n_tractions, n_values);
    for (unsigned int side = 0; side < 3; ++side)
      for (unsigned int end = 0; end < 2; ++end)
        add_traction(tractions,
                     traction_index(side, end, 0),
                     side,
                     end,
                     normal(triangle[side], triangle[(side + 1) % 3]));
    return tractions;
  }



  FullMatrix<double>
  divergence_matrix(const Triangle &triangle)
  {
    FullMatrix<double> divergence(6, n_values);
    for (unsigned int subtriangle = 0; subtriangle < 3; ++subtriangle)
      {
        const auto gradient = gradients(subtriangle_of(triangle, subtriangle));
        for (unsigned int corner = 0; corner < 3; ++corner)
          add_traction(
            divergence, 2 * subtriangle, subtriangle, corner, gradient[corner]);
      }
    return divergence;
  }



  // Twelve conditions of continuity and fifteen degrees of freedom determine
  // the 27 values.
  FullMatrix<double>
  shape_functions(const Triangle &triangle)
  {
    FullMatrix<double> conditions(n_values, n_values);
    fill_rows(conditions, 0, jump_matrix(triangle));
    fill_rows(conditions, 12, traction_matrix(triangle));
    for (unsigned int subtriangle = 0; subtriangle < 3; ++subtriangle)
      for (unsigned int corner = 0; corner < 3; ++corner)
        for (unsigned int component = 0; component < 3; ++component)
          conditions(24 + component,
                     value_index(subtriangle, corner, component)) = 1. / 9.;

    conditions.gauss_jordan();
    FullMatrix<double> basis(n_values, n_dofs);
    basis.fill(conditions, 0, 0, 0, 12);
    return basis;
  }



  // Piola's transformation B tau B^T carries stresses without divergence and
  // with continuous tractions from the reference triangle to any other.
  FullMatrix<double>
  equilibrated_basis(const Triangle &triangle)
  {
    static const FullMatrix<double> reference = reference_equilibrated_basis();

    const Tensor<1, 2> b0 = triangle[1] - triangle[0],
                       b1 = triangle[2] - triangle[0];
    const double scale    = 1. / std::sqrt(b0.norm_square() + b1.norm_square());
    Tensor<2, 2> piola;
    for (unsigned int d = 0; d < 2; ++d)
      {
        piola[d][0] = scale * b0[d];
        piola[d][1] = scale * b1[d];
      }

    FullMatrix<double> basis(n_values, n_equilibrated_dofs);
    Vector<double>     values(n_values);
    for (unsigned int j = 0; j < n_equilibrated_dofs; ++j)
      {
        for (unsigned int i = 0; i < n_values; ++i)
          values[i] = reference(i, j);
        for (unsigned int subtriangle = 0; subtriangle < 3; ++subtriangle)
          for (unsigned int corner = 0; corner < 3; ++corner)
            {
              const Tensor<2, 2> stress =
                piola * Tensor<2, 2>(stress_at(values, subtriangle, corner)) *
                transpose(piola);
              basis(value_index(subtriangle, corner, 0), j) = stress[0][0];
              basis(value_index(subtriangle, corner, 1), j) = stress[1][1];
              basis(value_index(subtriangle, corner, 2), j) = stress[0][1];
            }
      }
    return basis;
  }



  Vector<double>
  interpolate(
    const Triangle                                               &triangle,
    const std::function<SymmetricTensor<2, 2>(const Point<2> &)> &stress)
  {
    Vector<double> dofs(n_dofs);
    for (unsigned int side = 0; side < 3; ++side)
      {
        const Point<2> a = triangle[side], b = triangle[(side + 1) % 3];
        integrate_on_side(
          a, b, [&](const double t, const Point<2> &x, const double weight) {
            const Tensor<1, 2> traction = stress(x) * normal(a, b);
            for (unsigned int c = 0; c < 2; ++c)
              {
                const double w = weight * traction[c];
                dofs[traction_index(side, 0, c)] += w * (4. - 6. * t);
                dofs[traction_index(side, 1, c)] += w * (6. * t - 2.);
              }
          });
      }

    const QGaussSimplex<2> inside(3);
    const Tensor<1, 2>     b0 = triangle[1] - triangle[0],
                       b1     = triangle[2] - triangle[0];
    for (unsigned int q = 0; q < inside.size(); ++q)
      {
        const auto  &x     = inside.point(q);
        const auto   value = stress(triangle[0] + x[0] * b0 + x[1] * b1);
        const double w     = 2. * inside.weight(q);
        dofs[12] += w * value[0][0];
        dofs[13] += w * value[1][1];
        dofs[14] += w * value[0][1];
      }
    return dofs;
  }
} // namespace ElastoPlastic::JohnsonMercier
