// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The Johnson-Mercier element: its degrees of freedom determine a stress, its
// tractions are continuous inside, the divergence of its interpolation, order
// of convergence.

#include <deal.II/base/mpi.h>

#include <cmath>

#include "equilibrium/johnson_mercier.h"
#include "equilibrium/split_mesh.h"
#include "verdict.h"

using namespace ElastoPlastic;
using namespace ElastoPlastic::JohnsonMercier;

namespace
{
  const Triangle triangle = {{Point<2>(0.3, -0.2), {2.1, 0.4}, {1.2, 1.7}}};



  /// The largest jump of the tractions inside, for the stress in a column.
  double
  largest_jump(const FullMatrix<double> &basis)
  {
    double         largest = 0;
    Vector<double> values(n_values);
    for (unsigned int j = 0; j < basis.n(); ++j)
      {
        for (unsigned int i = 0; i < n_values; ++i)
          values[i] = basis(i, j);
        for (unsigned int k = 0; k < 3; ++k)
          {
            const Tensor<1, 2> normal =
              cross_product_2d(subtriangle_of(triangle, k)[2] - triangle[k]);
            const unsigned int before = (k + 2) % 3;
            largest                   = std::max(
              {largest,
                                 ((stress_at(values, k, 0) - stress_at(values, before, 1)) *
                normal)
                                   .norm(),
                                 ((stress_at(values, k, 2) - stress_at(values, before, 2)) *
                normal)
                                   .norm()});
          }
      }
    return largest;
  }



  double
  largest_entry(const FullMatrix<double> &a, const FullMatrix<double> &b)
  {
    FullMatrix<double> product(a.m(), b.n());
    a.mmult(product, b);
    return product.linfty_norm();
  }



  void
  test_basis()
  {
    const FullMatrix<double> shapes = shape_functions(triangle);
    verify("shape functions, jumps inside", largest_jump(shapes), 1e-13);

    FullMatrix<double> tractions(n_tractions, n_dofs);
    traction_matrix(triangle).mmult(tractions, shapes);
    for (unsigned int i = 0; i < n_tractions; ++i)
      tractions(i, i) -= 1.;
    verify("dual to the tractions", tractions.linfty_norm(), 1e-12);

    const FullMatrix<double> basis = equilibrated_basis(triangle);
    verify("equilibrated basis, jumps inside", largest_jump(basis), 1e-13);
    verify("equilibrated basis, divergence",
           largest_entry(divergence_matrix(triangle), basis),
           1e-13);
    FullMatrix<double> gram(n_equilibrated_dofs, n_equilibrated_dofs);
    basis.Tmmult(gram, basis);
    verify("equilibrated basis, independent", gram.determinant() > 1e-12);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_basis();
}
