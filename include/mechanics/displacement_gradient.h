// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_displacement_gradient_h
#define mechanics_displacement_gradient_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>

#include "base/simd.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The number of entries of a displacement gradient that need not vanish: in
  /// two dimensions those in the plane and, last, the stretch out of it, in an
  /// axisymmetric body u_r / r.
  template <int dim>
  constexpr unsigned int n_gradient_entries = (dim == 2 ? 5 : 9);

  /// These entries, row by row; and what is conjugate to them, a nominal
  /// stress.
  template <int dim, typename Number>
  using GradientEntries = Tensor<1, n_gradient_entries<dim>, Number>;



  /// Row and column of an entry.
  template <int dim>
  constexpr std::array<unsigned int, 2>
  place_of_entry(const unsigned int entry)
  {
    if (dim == 2 && entry == 4)
      return {{2, 2}};
    return {{entry / dim, entry % dim}};
  }



  template <int dim, typename Number>
  ELASTO_PLASTIC_ALWAYS_INLINE inline Tensor<2, 3, Number>
  as_matrix(const GradientEntries<dim, Number> &entries)
  {
    Tensor<2, 3, Number> matrix;
    for (unsigned int k = 0; k < n_gradient_entries<dim>; ++k)
      {
        const auto [i, j] = place_of_entry<dim>(k);
        matrix[i][j]      = entries[k];
      }
    return matrix;
  }



  template <int dim, typename Number>
  ELASTO_PLASTIC_ALWAYS_INLINE inline GradientEntries<dim, Number>
  as_entries(const Tensor<2, 3, Number> &matrix)
  {
    GradientEntries<dim, Number> entries;
    for (unsigned int k = 0; k < n_gradient_entries<dim>; ++k)
      {
        const auto [i, j] = place_of_entry<dim>(k);
        entries[k]        = matrix[i][j];
      }
    return entries;
  }



  /// The derivative of a nominal stress with respect to the displacement
  /// gradient, column by column; @p stress_of makes the one of the other.
  template <int dim, typename Number, typename Stress>
  Tensor<2, n_gradient_entries<dim>, Number>
  nominal_derivative(const Stress &stress_of)
  {
    Tensor<2, n_gradient_entries<dim>, Number> derivative;
    for (unsigned int k = 0; k < n_gradient_entries<dim>; ++k)
      {
        GradientEntries<dim, Number> unit;
        unit[k] = Number(1.);
        const GradientEntries<dim, Number> column =
          as_entries<dim>(stress_of(as_matrix<dim>(unit)));
        for (unsigned int l = 0; l < n_gradient_entries<dim>; ++l)
          derivative[l][k] = column[l];
      }
    return derivative;
  }
} // namespace ElastoPlastic

#endif
