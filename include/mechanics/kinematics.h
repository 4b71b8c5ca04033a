// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_kinematics_h
#define mechanics_kinematics_h

#include <deal.II/base/symmetric_tensor.h>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The deviator, in three dimensions, of the strain of a body in space
  /// (dim = 3) or in plane strain (dim = 2: all out-of-plane components of
  /// @p strain are zero, those of its deviator are not).
  template <int dim, typename Number>
  SymmetricTensor<2, 3, Number>
  strain_deviator(const SymmetricTensor<2, dim, Number> &strain)
  {
    SymmetricTensor<2, 3, Number> deviator;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i; j < dim; ++j)
        deviator[i][j] = strain[i][j];
    const Number mean = trace(strain) * (1. / 3.);
    for (unsigned int i = 0; i < 3; ++i)
      deviator[i][i] -= mean;
    return deviator;
  }



  /// The components of a three-dimensional @p tensor in the space that the
  /// displacement lives in.
  template <int dim, typename Number>
  SymmetricTensor<2, dim, Number>
  in_plane(const SymmetricTensor<2, 3, Number> &tensor)
  {
    SymmetricTensor<2, dim, Number> result;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i; j < dim; ++j)
        result[i][j] = tensor[i][j];
    return result;
  }
} // namespace ElastoPlastic

#endif
