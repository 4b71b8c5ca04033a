// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The Johnson-Mercier element on a tetrahedron: how many stresses there are,
// what determines them, and that Piola's transformation keeps what they
// promise.

#include <deal.II/base/mpi.h>

#include <cmath>

#include "bounds/conic/local_algebra.h"
#include "bounds/conic/yield_conditions.h"
#include "bounds/stress/johnson_mercier.h"
#include "element_tractions.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Element = JohnsonMercier<3>;

  constexpr unsigned int n_values = Element::n_values(1);

  const Corners<3> tetrahedron = {{Point<3>(0.3, -0.2, 0.1),
                                   Point<3>(2.1, 0.4, -0.3),
                                   Point<3>(1.2, 1.7, 0.2),
                                   Point<3>(0.8, 0.5, 1.9)}};



  /// So many rows of conditions, one matrix below the other.
  FullMatrix<double>
  joined(const FullMatrix<double> &a, const FullMatrix<double> &b)
  {
    FullMatrix<double> result(a.m() + b.m(), n_values);
    result.fill(a);
    result.fill(b, a.m());
    return result;
  }



  double
  largest_entry(const FullMatrix<double> &a, const FullMatrix<double> &b)
  {
    FullMatrix<double> product(a.m(), b.n());
    a.mmult(product, b);
    return product.linfty_norm();
  }



  /// The values of a stress given as a function of the position.
  template <typename Stress>
  Vector<double>
  values_of(const Stress &stress)
  {
    Vector<double> values(n_values);
    for (unsigned int k = 0; k < Element::n_parts; ++k)
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int c = 0; c < Element::n_components; ++c)
          values[Element::value_index(1, k, i) + c] =
            stress(Element::part_of(tetrahedron, k)[i]).access_raw_entry(c);
    return values;
  }



  /// What is left of @p values by the best combination of a @p basis.
  double
  distance_from(const FullMatrix<double> &basis, const Vector<double> &values)
  {
    FullMatrix<double> square(basis.n(), basis.n());
    basis.Tmmult(square, basis);
    square.gauss_jordan();
    Vector<double> right(basis.n()), coefficients(basis.n()), rest = values;
    basis.Tvmult(right, values);
    square.vmult(coefficients, right);
    coefficients *= -1.;
    basis.vmult_add(rest, coefficients);
    return rest.linfty_norm();
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto jumps       = Element::jump_matrix(tetrahedron, 1),
             divergences = Element::divergence_matrix(tetrahedron, 1);
  output() << "Stresses: " << LocalAlgebra::kernel(jumps).m()
           << ", without divergence: "
           << LocalAlgebra::kernel(joined(jumps, divergences)).m()
           << ", without tractions: "
           << LocalAlgebra::kernel(
                joined(jumps, ElementTractions<3>::matrix(tetrahedron, 1)))
                .m()
           << std::endl;

  const FullMatrix<double> basis = Element::equilibrated_basis(tetrahedron, 1);
  output() << "Basis: " << basis.n() << std::endl;
  FullMatrix<double> transposed(basis.n(), basis.m());
  transposed.copy_transposed(basis);
  verify("independent",
         LocalAlgebra::kernel(transposed).m() == n_values - basis.n());
  verify("continuous tractions", largest_entry(jumps, basis), 1e-13);
  verify("no divergence", largest_entry(divergences, basis), 1e-13);

  verify("contains a linear stress without divergence",
         distance_from(basis, values_of([](const Point<3> &x) {
                         SymmetricTensor<2, 3> stress;
                         stress[0][0] = 1. + x[0] + x[1];
                         stress[0][1] = 0.5 - x[1] + 2. * x[2];
                         stress[1][2] = x[0] - 3. * x[1];
                         stress[2][2] = 3. * x[2] - x[1];
                         stress[1][1] = x[2];
                         return stress;
                       })) < 1e-12);
  verify("but no other", distance_from(basis, values_of([](const Point<3> &x) {
                                         SymmetricTensor<2, 3> stress;
                                         stress[0][0] = x[0];
                                         return stress;
                                       })) > 0.1);

  SymmetricTensor<2, 3> stress;
  Vector<double>        components(Element::n_components);
  for (unsigned int c = 0; c < Element::n_components; ++c)
    stress.access_raw_entry(c) = components[c] = std::cos(1. + c * c);
  Vector<double> of_deviator(5);
  deviator_matrix<3>().vmult(of_deviator, components);
  verify("norm of the deviator",
         std::abs(of_deviator.l2_norm() - deviator(stress).norm()),
         1e-14);
}
