// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The Johnson-Mercier element of the first and second degree: tractions are
// continuous inside, the divergence is that of the polynomials, and the
// dimensions of its spaces are those of the theory.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include "bounds/conic/local_algebra.h"
#include "bounds/mesh/split_mesh.h"
#include "bounds/stress/johnson_mercier.h"
#include "element_tractions.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Element = JohnsonMercier<2>;

  const Corners<2> triangle = {{Point<2>(0.3, -0.2), {2.1, 0.4}, {1.2, 1.7}}};



  /// A stress at a point of a subtriangle.
  SymmetricTensor<2, 2>
  stress_at(const Vector<double> &values,
            const unsigned int    degree,
            const unsigned int    subtriangle,
            const Barycentric<2> &point)
  {
    const auto            functions = Bernstein<2>::functions(degree, point);
    SymmetricTensor<2, 2> stress;
    for (unsigned int i = 0; i < functions.size(); ++i)
      stress +=
        functions[i] * ElementTractions<2>::coefficient(values, subtriangle, i);
    return stress;
  }



  Vector<double>
  column(const FullMatrix<double> &matrix, const unsigned int j)
  {
    Vector<double> values(matrix.m());
    for (unsigned int i = 0; i < matrix.m(); ++i)
      values[i] = matrix(i, j);
    return values;
  }



  /// The largest jump of the tractions at points of the lines inside.
  double
  largest_jump(const FullMatrix<double> &basis, const unsigned int degree)
  {
    double largest = 0;
    for (unsigned int j = 0; j < basis.n(); ++j)
      for (unsigned int k = 0; k < 3; ++k)
        {
          const Vector<double> values = column(basis, j);
          const Tensor<1, 2>   normal =
            cross_product_2d(Element::part_of(triangle, k)[2] - triangle[k]);
          for (const double t : {0., 0.3, 0.8, 1.})
            {
              const SymmetricTensor<2, 2> jump =
                stress_at(values, degree, k, {{1. - t, 0., t}}) -
                stress_at(values, degree, (k + 2) % 3, {{0., 1. - t, t}});
              largest = std::max(largest, (jump * normal).norm());
            }
        }
    return largest;
  }



  /// The largest difference between the divergence and quotients of
  /// differences, which are exact for quadratic polynomials.
  double
  divergence_error(const FullMatrix<double> &basis, const unsigned int degree)
  {
    FullMatrix<double> divergence(Element::n_divergences(degree), basis.n());
    Element::divergence_matrix(triangle, degree).mmult(divergence, basis);
    const Barycentric<2> middle  = {{0.2, 0.5, 0.3}};
    const auto           weights = Bernstein<2>::functions(degree - 1, middle);

    double largest = 0;
    for (unsigned int j = 0; j < basis.n(); ++j)
      for (unsigned int k = 0; k < 3; ++k)
        {
          Tensor<1, 2> sum;
          const auto   by = gradients(Element::part_of(triangle, k));
          for (unsigned int d = 0; d < 2; ++d)
            {
              constexpr double step  = 0.1;
              auto             after = middle, before = middle;
              for (unsigned int i = 0; i < 3; ++i)
                {
                  after[i] += step * by[i][d];
                  before[i] -= step * by[i][d];
                }
              sum += (stress_at(column(basis, j), degree, k, after) -
                      stress_at(column(basis, j), degree, k, before)) *
                     Point<2>::unit_vector(d) / (2. * step);
            }
          for (unsigned int b = 0; b < weights.size(); ++b)
            for (unsigned int c = 0; c < 2; ++c)
              sum[c] -=
                weights[b] * divergence(2 * (weights.size() * k + b) + c, j);
          largest = std::max(largest, sum.norm());
        }
    return largest;
  }



  unsigned int
  rank(const FullMatrix<double> &matrix)
  {
    return matrix.n() - LocalAlgebra::kernel(matrix).m();
  }



  FullMatrix<double>
  product(const FullMatrix<double> &a, const FullMatrix<double> &b)
  {
    FullMatrix<double> result(a.m(), b.n());
    a.mmult(result, b);
    return result;
  }



  // Airy's functions of equilibrated stresses are the continuously
  // differentiable splines of degree n + 2 on three subtriangles, less the
  // linear functions: 3 (n^2 + 3 n + 4) / 2 - 3 [lai_schumaker_2007]. Their
  // tractions are all that have neither resultant nor moment.
  void
  test_degree(const unsigned int n)
  {
    output() << "Degree " << n << std::endl;
    const FullMatrix<double> all = Element::basis(triangle, n),
                             equilibrated =
                               Element::equilibrated_basis(triangle, n);
    verify("jumps inside", largest_jump(all, n), 1e-13);
    verify("divergence", divergence_error(all, n), 1e-12);
    verify("all stresses",
           rank(all) == all.n() &&
             all.n() == Element::n_values(n) - ElementTractions<2>::size(n) &&
             rank(product(Element::divergence_matrix(triangle, n), all)) ==
               Element::n_divergences(n));
    verify("equilibrated, jumps inside", largest_jump(equilibrated, n), 1e-13);
    verify("equilibrated, divergence",
           product(Element::divergence_matrix(triangle, n), equilibrated)
             .linfty_norm(),
           1e-13);
    verify("equilibrated stresses",
           rank(equilibrated) == equilibrated.n() &&
             equilibrated.n() == 3 * (n * n + 3 * n + 4) / 2 - 3);
    verify("their tractions",
           rank(product(ElementTractions<2>::matrix(triangle, n),
                        equilibrated)) == ElementTractions<2>::size(n) - 3);
  }



  // In space, too, the divergence is that of the polynomials, and the tractions
  // of equilibrated stresses are all that have neither resultant nor moment.
  // See also tetrahedron_stress.
  void
  test_space(const unsigned int n)
  {
    using InSpace                 = JohnsonMercier<3>;
    const Corners<3> tetrahedron  = {{Point<3>(0.3, -0.2, 0.1),
                                      Point<3>(2.1, 0.4, -0.3),
                                      Point<3>(1.2, 1.7, 0.2),
                                      Point<3>(0.8, 0.5, 1.9)}};
    const auto       all          = InSpace::basis(tetrahedron, n);
    const auto       equilibrated = InSpace::equilibrated_basis(tetrahedron, n);
    const auto       jumps        = InSpace::jump_matrix(tetrahedron, n);
    const auto       divergence   = InSpace::divergence_matrix(tetrahedron, n);
    output() << "Degree " << n << " in space" << std::endl;
    verify("jumps inside", product(jumps, all).linfty_norm(), 1e-12);
    verify("all stresses",
           rank(all) == all.n() &&
             rank(product(divergence, all)) == InSpace::n_divergences(n));
    verify("equilibrated, divergence",
           product(divergence, equilibrated).linfty_norm(),
           1e-12);
    verify("equilibrated stresses",
           rank(equilibrated) == equilibrated.n() &&
             equilibrated.n() + InSpace::n_divergences(n) == all.n());
    verify("their tractions",
           rank(product(ElementTractions<3>::matrix(tetrahedron, n),
                        equilibrated)) == ElementTractions<3>::size(n) - 6);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_degree(1);
  test_degree(2);
  test_space(1);
  test_space(2);
}
