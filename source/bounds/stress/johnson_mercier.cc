// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/conic/local_algebra.h"
#include "bounds/mesh/split_mesh.h"
#include "bounds/stress/johnson_mercier.h"

namespace ElastoPlastic::JohnsonMercier
{
  namespace
  {
    /// Adds the traction of a coefficient, whose component 11 is in column
    /// @p value, on a plane with this @p normal to two rows of @p matrix.
    void
    add_traction(FullMatrix<double> &matrix,
                 const unsigned int  row,
                 const unsigned int  value,
                 const Tensor<1, 2> &normal)
    {
      matrix(row, value) += normal[0];
      matrix(row, value + 2) += normal[1];
      matrix(row + 1, value + 2) += normal[0];
      matrix(row + 1, value + 1) += normal[1];
    }



    Tensor<1, 2>
    normal(const Point<2> &begin, const Point<2> &end)
    {
      return cross_product_2d(end - begin) / begin.distance(end);
    }



    /// The jumps of the tractions on the three lines between subtriangles. The
    /// line to corner k is side 1 of the subtriangle before and side 2 of
    /// subtriangle k.
    FullMatrix<double>
    jump_matrix(const Triangle &triangle, const unsigned int degree)
    {
      FullMatrix<double> jumps(n_tractions(degree), n_values(degree));
      for (unsigned int k = 0; k < 3; ++k)
        {
          const Triangle     subtriangle = subtriangle_of(triangle, k);
          const Tensor<1, 2> n      = normal(subtriangle[0], subtriangle[2]);
          const unsigned int before = (k + 2) % 3;
          for (unsigned int i = 0; i <= degree; ++i)
            {
              const unsigned int row   = traction_index(degree, k, i, 0);
              const unsigned int here  = number_on_line(degree, 0, 2, i),
                                 there = number_on_line(degree, 1, 2, i);
              add_traction(jumps, row, value_index(degree, k, here), n);
              add_traction(jumps, row, value_index(degree, before, there), -n);
            }
        }
      return jumps;
    }



    /// A basis of the kernel of @p conditions on the reference triangle, one
    /// per column.
    FullMatrix<double>
    kernel_of(const FullMatrix<double> &conditions)
    {
      const FullMatrix<double> rows = LocalAlgebra::kernel(conditions);
      FullMatrix<double>       columns(rows.n(), rows.m());
      columns.copy_transposed(rows);
      return columns;
    }



    /// The bases of the reference triangle.
    struct ReferenceBases
    {
      FullMatrix<double> all, equilibrated;

      explicit ReferenceBases(const unsigned int degree)
      {
        const Triangle     triangle   = {{Point<2>(0, 0), {1, 0}, {0, 1}}};
        const auto         jumps      = jump_matrix(triangle, degree);
        const auto         divergence = divergence_matrix(triangle, degree);
        FullMatrix<double> conditions(jumps.m() + divergence.m(), jumps.n());
        conditions.fill(jumps, 0, 0);
        conditions.fill(divergence, jumps.m(), 0);
        all          = kernel_of(jumps);
        equilibrated = kernel_of(conditions);
      }
    };



    const ReferenceBases &
    reference_bases(const unsigned int degree)
    {
      static const std::array<ReferenceBases, 2> by_degrees = {
        {ReferenceBases(1), ReferenceBases(2)}};
      AssertIndexRange(degree - 1, by_degrees.size());
      return by_degrees[degree - 1];
    }



    // Piola's transformation B tau B^T carries stresses with continuous
    // tractions, and those without divergence, from the reference triangle to
    // any other.
    FullMatrix<double>
    transform(const FullMatrix<double> &reference, const Triangle &triangle)
    {
      const Tensor<1, 2> b0 = triangle[1] - triangle[0],
                         b1 = triangle[2] - triangle[0];
      const double scale = 1. / std::sqrt(b0.norm_square() + b1.norm_square());
      Tensor<2, 2> piola;
      for (unsigned int d = 0; d < 2; ++d)
        {
          piola[d][0] = scale * b0[d];
          piola[d][1] = scale * b1[d];
        }

      FullMatrix<double> basis(reference.m(), reference.n());
      for (unsigned int i = 0; i < basis.m(); i += 3)
        for (unsigned int j = 0; j < basis.n(); ++j)
          {
            Tensor<2, 2> stress;
            stress[0][0] = reference(i, j);
            stress[1][1] = reference(i + 1, j);
            stress[0][1] = stress[1][0] = reference(i + 2, j);
            stress                      = piola * stress * transpose(piola);
            basis(i, j)                 = stress[0][0];
            basis(i + 1, j)             = stress[1][1];
            basis(i + 2, j)             = stress[0][1];
          }
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
  coefficient(const Vector<double> &values,
              const unsigned int    subtriangle,
              const unsigned int    i)
  {
    const unsigned int    first = values.size() / 3 * subtriangle + 3 * i;
    SymmetricTensor<2, 2> stress;
    stress[0][0] = values[first];
    stress[1][1] = values[first + 1];
    stress[0][1] = values[first + 2];
    return stress;
  }



  unsigned int
  number_on_line(const unsigned int degree,
                 const unsigned int from,
                 const unsigned int to,
                 const unsigned int i)
  {
    Bernstein::Exponents exponents = {};
    exponents[from]                = degree - i;
    exponents[to]                  = i;
    return Bernstein::number_of(exponents);
  }



  FullMatrix<double>
  basis(const Triangle &triangle, const unsigned int degree)
  {
    return transform(reference_bases(degree).all, triangle);
  }



  FullMatrix<double>
  equilibrated_basis(const Triangle &triangle, const unsigned int degree)
  {
    return transform(reference_bases(degree).equilibrated, triangle);
  }



  FullMatrix<double>
  traction_matrix(const Triangle &triangle, const unsigned int degree)
  {
    FullMatrix<double> tractions(n_tractions(degree), n_values(degree));
    for (unsigned int side = 0; side < 3; ++side)
      for (unsigned int i = 0; i <= degree; ++i)
        add_traction(tractions,
                     traction_index(degree, side, i, 0),
                     value_index(degree, side, number_on_line(degree, 0, 1, i)),
                     normal(triangle[side], triangle[(side + 1) % 3]));
    return tractions;
  }



  // The gradient of sum_a c_a B_a is n sum_b (sum_i c_{b + e_i} grad lambda_i)
  // B_b over the functions of degree n - 1.
  FullMatrix<double>
  divergence_matrix(const Triangle &triangle, const unsigned int degree)
  {
    FullMatrix<double> divergence(n_divergences(degree), n_values(degree));
    const auto        &lower = Bernstein::exponents(degree - 1);
    for (unsigned int k = 0; k < 3; ++k)
      {
        const auto gradient = gradients(subtriangle_of(triangle, k));
        for (unsigned int b = 0; b < lower.size(); ++b)
          for (unsigned int i = 0; i < 3; ++i)
            {
              Bernstein::Exponents raised = lower[b];
              ++raised[i];
              add_traction(divergence,
                           2 * (lower.size() * k + b),
                           value_index(degree, k, Bernstein::number_of(raised)),
                           1. * degree * gradient[i]);
            }
      }
    return divergence;
  }
} // namespace ElastoPlastic::JohnsonMercier
