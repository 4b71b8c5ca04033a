// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_reference_tangent_h
#define mechanics_reference_tangent_h

#include "mechanics/nominal_tangent.h"

namespace ElastoPlastic
{
  /// A tangent of a cell in space for gradients with respect to the cell's
  /// reference coordinates xi, which run from 0 to 1; the conjugate stresses
  /// are integrated over these. If the map from xi to x is affine,
  ///   du_i / dx_j = sum_d du_i / dxi_d  dxi_d / dx_j ,
  /// this says all that a product needs to know of the cell, so that each cell
  /// is a unit cube; else it is an approximation.
  template <int dim, typename Number>
  class ReferenceTangent
  {
  public:
    ReferenceTangent() = default;

    /// Of the @p tangent and its @p bulk_modulus in a cell of this @p volume;
    /// @p xi_by_x has the dxi_d / dx_j, j being the first index, as in
    /// FEEvaluation::inverse_jacobian().
    ReferenceTangent(const NominalTangent<dim, Number> &tangent,
                     const Number                      &bulk_modulus,
                     const Tensor<2, dim, Number>      &xi_by_x,
                     const Number                      &volume)
      : bulk_modulus(volume * bulk_modulus)
    {
      nominal.volumetric_slope = pull_back(tangent.volumetric_slope, xi_by_x);
      Tensor<2, n, Number> columns;
      for (unsigned int l = 0; l < n; ++l)
        {
          Entries gradient;
          for (unsigned int j = 0; j < dim; ++j)
            gradient[l / dim * dim + j] = volume * xi_by_x[j][l % dim];
          columns[l] = pull_back(tangent.stiffness * gradient, xi_by_x);
        }
      nominal.stiffness = NominalStiffness<dim, Number>(columns);
    }

    // (what FiniteIncrement::stress_of_mode() takes)
    const NominalTangent<dim, Number> &
    nominal_tangent() const
    {
      return nominal;
    }

    const GradientEntries<dim, Number> &
    volumetric_slope(const unsigned int) const
    {
      return nominal.volumetric_slope;
    }

    Number bulk_modulus;

  private:
    static constexpr unsigned int n = n_gradient_entries<dim>;
    using Entries                   = GradientEntries<dim, Number>;

    /// The stress that is conjugate to a gradient with respect to xi.
    static Entries
    pull_back(const Entries &stress, const Tensor<2, dim, Number> &xi_by_x)
    {
      Entries result;
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int j = 0; j < dim; ++j)
          result[k] += stress[k / dim * dim + j] * xi_by_x[j][k % dim];
      return result;
    }

    NominalTangent<dim, Number> nominal;
  };
} // namespace ElastoPlastic

#endif
