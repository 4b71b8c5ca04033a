// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_nominal_tangent_h
#define mechanics_nominal_tangent_h

#include <deal.II/base/symmetric_tensor.h>

#include "mechanics/displacement_gradient.h"

namespace ElastoPlastic
{
  /// The tangent of a finite deformation, or of a small one whose material has
  /// a GeneralCriterion: the derivative of the nominal stress with respect to
  /// the displacement gradient, both as GradientEntries, is
  ///   stiffness + K v v^T,
  /// where v is the slope of the volumetric strain. (With B-bar, its mean takes
  /// the place of the second v.)
  template <int dim, typename Number>
  struct NominalTangent
  {
    static constexpr unsigned int n           = n_gradient_entries<dim>;
    static constexpr unsigned int n_symmetric = n * (n + 1) / 2;
    static constexpr unsigned int n_values    = n_symmetric + n;

    SymmetricTensor<2, n, Number> stiffness;
    Tensor<1, n, Number>          volumetric_slope;

    /// Adds to @p stress the product of the stiffness with @p gradient, both
    /// with n entries; those for which @p is_zero holds are left out of all
    /// three. (deal.II's product searches the place of each entry of so large a
    /// tensor; here, the compiler knows it.)
    template <typename IsZero>
    ELASTO_PLASTIC_ALWAYS_INLINE inline void
    add_stiffness_times(Number *const       stress,
                        const Number *const gradient,
                        const IsZero       &is_zero) const
    {
      unsigned int entry = n;
#pragma GCC unroll 9
      for (unsigned int i = 0; i < n; ++i)
        {
          if (!is_zero(i))
            stress[i] += stiffness.access_raw_entry(i) * gradient[i];
#pragma GCC unroll 9
          for (unsigned int j = i + 1; j < n; ++j, ++entry)
            if (!is_zero(i) && !is_zero(j))
              {
                const Number &k_ij = stiffness.access_raw_entry(entry);
                stress[i] += k_ij * gradient[j];
                stress[j] += k_ij * gradient[i];
              }
        }
    }

    ELASTO_PLASTIC_ALWAYS_INLINE inline Tensor<1, n, Number>
    stiffness_times(const Tensor<1, n, Number> &gradient) const
    {
      Tensor<1, n, Number> stress;
      add_stiffness_times(&stress[0], &gradient[0], [](const unsigned int) {
        return false;
      });
      return stress;
    }

    /// One of the n_values numbers that it consists of.
    Number &
    value(const unsigned int i)
    {
      return i < n_symmetric ? stiffness.access_raw_entry(i) :
                               volumetric_slope[i - n_symmetric];
    }

    const Number &
    value(const unsigned int i) const
    {
      return const_cast<NominalTangent &>(*this).value(i);
    }
  };



  /// What an unsymmetric stiffness has beside its symmetric part.
  template <int dim, typename Number>
  struct SkewPart
  {
    static constexpr unsigned int n = n_gradient_entries<dim>;

    Tensor<1, n *(n - 1) / 2, Number> above_diagonal;

    explicit SkewPart(const Tensor<2, n, Number> &matrix)
    {
      for (unsigned int i = 0, k = 0; i < n; ++i)
        for (unsigned int j = i + 1; j < n; ++j, ++k)
          above_diagonal[k] = 0.5 * (matrix[i][j] - matrix[j][i]);
    }

    SkewPart() = default;

    Tensor<1, n, Number>
    operator*(const Tensor<1, n, Number> &vector) const
    {
      Tensor<1, n, Number> product;
      for (unsigned int i = 0, k = 0; i < n; ++i)
        for (unsigned int j = i + 1; j < n; ++j, ++k)
          {
            product[i] += above_diagonal[k] * vector[j];
            product[j] -= above_diagonal[k] * vector[i];
          }
      return product;
    }
  };
} // namespace ElastoPlastic

#endif
