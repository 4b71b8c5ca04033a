// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_tensors_h
#define base_tensors_h

#include <deal.II/base/symmetric_tensor.h>

#include "base/simd.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The deviator of a @p strain.
  template <typename Number>
  SymmetricTensor<2, 3, Number>
  strain_deviator(const SymmetricTensor<2, 3, Number> &strain)
  {
    SymmetricTensor<2, 3, Number> deviator = strain;
    const Number                  mean     = trace(strain) * (1. / 3.);
    for (unsigned int i = 0; i < 3; ++i)
      deviator[i][i] -= mean;
    return deviator;
  }



  /// The components of a three-dimensional @p tensor in the space of the mesh.
  template <int dim, typename Number>
  ELASTO_PLASTIC_ALWAYS_INLINE inline SymmetricTensor<2, dim, Number>
  in_plane(const SymmetricTensor<2, 3, Number> &tensor)
  {
    if constexpr (dim == 3)
      return tensor;
    else
      {
        SymmetricTensor<2, dim, Number> result;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = i; j < dim; ++j)
            result[i][j] = tensor[i][j];
        return result;
      }
  }



  /// The inverse of in_plane(): the three-dimensional tensor with the
  /// components @p tensor in the space of the mesh and, in two dimensions, the
  /// out-of-plane component @p out_of_plane.
  template <int dim, typename Number>
  ELASTO_PLASTIC_ALWAYS_INLINE inline SymmetricTensor<2, 3, Number>
  in_space(const SymmetricTensor<2, dim, Number> &tensor,
           [[maybe_unused]] const Number         &out_of_plane)
  {
    if constexpr (dim == 3)
      return tensor;
    else
      {
        SymmetricTensor<2, 3, Number> result;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = i; j < dim; ++j)
            result[i][j] = tensor[i][j];
        result[2][2] = out_of_plane;
        return result;
      }
  }
} // namespace ElastoPlastic

#endif
