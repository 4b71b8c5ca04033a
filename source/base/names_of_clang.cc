// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Where the type of a template depends on a member of another one, clang 14
// writes it differently into the name of the symbol from GCC, which has
// compiled the packages of deal.II. So clang does not find these functions in
// the library, and they are compiled here once more, with types spelled as
// where they are declared, which goes into the names, too. (For clang only:
// cmake/parts_library.cmake)

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/distributed/p4est_wrappers.h>
#include <deal.II/lac/la_parallel_vector.h>
#ifdef WITH_TRILINOS_SOLVERS
#  include <deal.II/lac/trilinos_sparse_matrix.h>

#  include <Epetra_MultiVector.h>
#endif

#include <algorithm>

DEAL_II_NAMESPACE_OPEN

template <>
std::array<std::pair<double, Tensor<1, 3>>,
           std::integral_constant<int, 3>::value>
eigenvectors(const SymmetricTensor<2, 3>           &tensor,
             const SymmetricTensorEigenvectorMethod method)
{
  namespace Methods = internal::SymmetricTensorImplementation;
  auto pairs        = method == SymmetricTensorEigenvectorMethod::jacobi ?
                        Methods::jacobi(tensor) :
                      method == SymmetricTensorEigenvectorMethod::hybrid ?
                        Methods::hybrid(tensor) :
                        Methods::ql_implicit_shifts(tensor);
  std::sort(pairs.begin(),
            pairs.end(),
            Methods::SortEigenValuesVectors<3, double>());
  return pairs;
}



namespace internal::p4est
{
  template <int dim>
  void
  init_quadrant_children(
    const typename types<dim>::quadrant &cell,
    typename types<dim>::quadrant (
      &children)[dealii::GeometryInfo<dim>::max_children_per_cell])
  {
    functions<dim>::quadrant_childrenv(&cell, children);
  }

  template void
  init_quadrant_children<2>(const types<2>::quadrant &,
                            types<2>::quadrant (&)[4]);
  template void
  init_quadrant_children<3>(const types<3>::quadrant &,
                            types<3>::quadrant (&)[8]);
} // namespace internal::p4est



#ifdef WITH_TRILINOS_SOLVERS
namespace TrilinosWrappers
{
  template <>
  void
  SparseMatrix::vmult(
    LinearAlgebra::distributed::Vector<double>       &dst,
    const LinearAlgebra::distributed::Vector<double> &src) const
  {
    const auto view = [](const auto &map, const auto &vector) {
      return Epetra_MultiVector(View,
                                map,
                                const_cast<double *>(vector.begin()),
                                vector.locally_owned_size(),
                                1);
    };
    auto      result = view(matrix->RangeMap(), dst);
    const int error =
      matrix->Multiply(false, view(matrix->DomainMap(), src), result);
    AssertThrow(error == 0, ExcTrilinosError(error));
  }
} // namespace TrilinosWrappers
#endif

DEAL_II_NAMESPACE_CLOSE
