// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_principal_frame_h
#define mechanics_principal_frame_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <cmath>

#include "base/simd.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The eigenvalues and eigenvectors of a symmetric tensor, on all lanes of a
  /// batch at once, which deal.II's eigenvectors() cannot do: by Jacobi's
  /// rotations @cite golub_van_loan_2013 (section 8.5), with masks in place of
  /// branches. In two dimensions, one of the eigenvectors is the third axis.
  template <int dim, typename Number>
  struct PrincipalFrame
  {
    using Matrix  = Tensor<2, 3, Number>;
    using Tensor3 = SymmetricTensor<2, 3, Number>;

    PrincipalFrame() = default;

    explicit PrincipalFrame(const Tensor3 &tensor)
    {
      Tensor3 rotated = tensor;
      for (unsigned int d = 0; d < 3; ++d)
        vectors[d][d] = Number(1.);
      if constexpr (dim == 2)
        rotate(rotated, 0, 1);
      else
        for (unsigned int sweep = 0; sweep < n_sweeps && !is_diagonal(rotated);
             ++sweep)
          {
            rotate(rotated, 0, 1);
            rotate(rotated, 0, 2);
            rotate(rotated, 1, 2);
          }
      for (unsigned int d = 0; d < 3; ++d)
        values[d] = rotated[d][d];
    }

    /// N^T @p tensor N
    Tensor3
    to_principal(const Tensor3 &tensor) const
    {
      return symmetrize(transpose(vectors) * Matrix(tensor) * vectors);
    }

    /// N @p tensor N^T
    Tensor3
    from_principal(const Tensor3 &tensor) const
    {
      return symmetrize(vectors * Matrix(tensor) * transpose(vectors));
    }

    std::array<Number, 3> values;
    /// N: the eigenvectors, as columns.
    Matrix vectors;

  private:
    /// At most. The off-diagonal entries fall at least quadratically from the
    /// third sweep on: four are enough, mostly.
    static constexpr unsigned int n_sweeps = 6;

    /// In all lanes, up to rounding errors.
    static bool
    is_diagonal(const Tensor3 &tensor)
    {
      const Number off_diagonal = std::abs(tensor[0][1]) +
                                  std::abs(tensor[0][2]) +
                                  std::abs(tensor[1][2]);
      const Number diagonal = std::abs(tensor[0][0]) + std::abs(tensor[1][1]) +
                              std::abs(tensor[2][2]);
      for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
        if (lane_of(off_diagonal, lane) > 1e-18 * lane_of(diagonal, lane))
          return false;
      return true;
    }

    /// Annihilates the entry (@p p, @p q).
    void
    rotate(Tensor3 &a, const unsigned int p, const unsigned int q)
    {
      // The tangent of the smaller angle: t = 2 a_pq sgn(d) / (|d| + root)
      const Number d    = a[q][q] - a[p][p];
      const Number root = std::sqrt(d * d + 4. * a[p][q] * a[p][q]);
      const Number sign = compare_and_apply_mask<SIMDComparison::less_than>(
        d, Number(0.), Number(-1.), Number(1.));
      const Number t =
        2. * a[p][q] * sign / std::max(std::abs(d) + root, Number(1e-300));
      const Number c = 1. / std::sqrt(1. + t * t);
      const Number s = t * c;

      a[p][p] -= t * a[p][q];
      a[q][q] += t * a[p][q];
      a[p][q]                 = Number(0.);
      const unsigned int r    = 3 - p - q;
      const Number       a_pr = a[p][r];
      a[p][r]                 = c * a_pr - s * a[q][r];
      a[q][r]                 = s * a_pr + c * a[q][r];
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Number v_p = vectors[i][p];
          vectors[i][p]    = c * v_p - s * vectors[i][q];
          vectors[i][q]    = s * v_p + c * vectors[i][q];
        }
    }
  };
} // namespace ElastoPlastic

#endif
