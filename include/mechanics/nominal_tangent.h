// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_nominal_tangent_h
#define mechanics_nominal_tangent_h

#include <array>

#include "mechanics/displacement_gradient.h"

namespace ElastoPlastic
{
  /// The symmetric matrix that makes nominal stresses of displacement
  /// gradients, both as GradientEntries. @p Number is what products are
  /// computed with, or what it becomes for storage.
  template <int dim, typename Number>
  struct NominalStiffness
  {
    static constexpr unsigned int n         = n_gradient_entries<dim>;
    static constexpr unsigned int n_entries = n * (n + 1) / 2;

    NominalStiffness() = default;

    /// The symmetric part of @p matrix.
    template <typename T>
    explicit NominalStiffness(const Tensor<2, n, T> &matrix)
    {
      Number *entry = entries.data();
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = i; j < n; ++j)
          *entry++ = T(0.5 * (matrix[i][j] + matrix[j][i]));
    }

    /// Adds to @p stress the product with @p gradient, both with n entries;
    /// those for which @p is_zero holds are left out of all three.
    template <typename T, typename IsZero>
    ELASTO_PLASTIC_ALWAYS_INLINE inline void
    add_product(T *const       stress,
                const T *const gradient,
                const IsZero  &is_zero) const
    {
      const Number *entry = entries.data();
#pragma GCC unroll 9
      for (unsigned int i = 0; i < n; ++i)
#pragma GCC unroll 9
        for (unsigned int j = i; j < n; ++j, ++entry)
          if (!is_zero(i) && !is_zero(j))
            {
              const T k_ij = *entry;
              stress[i] += k_ij * gradient[j];
              if (i != j)
                stress[j] += k_ij * gradient[i];
            }
    }

    template <typename T>
    ELASTO_PLASTIC_ALWAYS_INLINE inline GradientEntries<dim, T>
    operator*(const GradientEntries<dim, T> &gradient) const
    {
      GradientEntries<dim, T> stress;
      add_product(&stress[0], &gradient[0], [](const unsigned int) {
        return false;
      });
      return stress;
    }

    /// Row by row, from the diagonal on.
    std::array<Number, n_entries> entries{};
  };



  /// The tangent of a finite deformation, or of a small one whose material has
  /// a GeneralCriterion: the derivative of the nominal stress with respect to
  /// the displacement gradient, both as GradientEntries, is
  ///   stiffness + K v v^T,
  /// where v is the slope of the volumetric strain. (With B-bar, its mean takes
  /// the place of the second v.)
  template <int dim, typename Number>
  struct NominalTangent
  {
    static constexpr unsigned int n = n_gradient_entries<dim>;
    static constexpr unsigned int n_values =
      NominalStiffness<dim, Number>::n_entries + n;

    NominalStiffness<dim, Number> stiffness;
    GradientEntries<dim, Number>  volumetric_slope;

    /// One of the n_values numbers that it consists of.
    Number &
    value(const unsigned int i)
    {
      const unsigned int n_entries = n_values - n;
      return i < n_entries ? stiffness.entries[i] :
                             volumetric_slope[i - n_entries];
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
