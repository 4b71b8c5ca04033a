// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_general_small_strain_h
#define mechanics_general_small_strain_h

#include "mechanics/strain_measures.h"

namespace ElastoPlastic
{
  /// Small strains of materials whose tangent has no special form (a
  /// GeneralCriterion): tangents are nominal ones, as for finite strains.
  template <typename Coordinates>
  struct GeneralSmallStrain : FiniteIncrement<Coordinates>
  {
    static constexpr int dim = Coordinates::dim;

    template <typename Number>
    using Deformation =
      typename SmallStrain<Coordinates>::template Deformation<Number>;

    template <typename Number>
    static GradientEntries<dim, Number>
    conjugate(const Deformation<Number> &,
              const SymmetricTensor<2, 3, Number> &stress)
    {
      return as_entries<dim>(Tensor<2, 3, Number>(stress));
    }

    /// See FiniteStrain.
    template <typename Law, typename Number>
    static void
    linearize(Tensor<2, n_gradient_entries<dim>, Number> &derivative,
              GradientEntries<dim, Number>               &volumetric_slope,
              const Deformation<Number> &,
              const SymmetricTensor<2, 3, Number> &,
              const Law    &deviatoric_stress,
              const Number &bulk_modulus)
    {
      derivative = nominal_derivative<dim, Number>(
        [&](const Tensor<2, 3, Number> &gradient) {
          return Tensor<2, 3, Number>(SmallStrain<Coordinates>::linear_stress(
            deviatoric_stress, bulk_modulus, symmetrize(gradient), Number(0.)));
        });
      volumetric_slope = as_entries<dim>(
        Tensor<2, 3, Number>(unit_symmetric_tensor<3, Number>()));
    }
  };
} // namespace ElastoPlastic

#endif
