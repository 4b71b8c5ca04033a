// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_deviatoric_tangent_h
#define material_deviatoric_tangent_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/vectorization.h>

#include <cmath>

#include "base/simd.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The deviatoric part of a tangent, de -> a de - (m (l : de) + l (m : de))/2
  /// with a = 2 G theta, where m and l are the normal of the yield surface and
  /// the flow direction, both times sqrt(2 G theta_bar); for the consistent
  /// tangent they are the same (doc/theory, "Material"). Back stresses that
  /// recover make the tangent unsymmetric: de -> a de - l (m : de). Since both
  /// tensors are deviatoric, their in-plane parts (dim = 2) say all about them.
  template <int dim, typename Number>
  struct DeviatoricTangent
  {
    Number                          shear = Number(0.);
    SymmetricTensor<2, dim, Number> normal;
    SymmetricTensor<2, dim, Number> flow;

    /// The deviatoric stress increment that belongs to the increment @p strain:
    /// a de - share m (l : de) - (1 - share) l (m : de), with the @p share 1/2
    /// if the tangent is symmetric, and else 0.
    ELASTO_PLASTIC_ALWAYS_INLINE inline SymmetricTensor<2, 3, Number>
    product(const SymmetricTensor<2, 3, Number> &strain,
            const Number                        &share) const
    {
      const Number along_normal = share * contraction(flow, strain);
      const Number along_flow =
        (Number(1.) - share) * contraction(normal, strain);
      const Number mean = trace(strain) * (1. / 3.);

      // component by component: the compiler would copy whole tensors
      SymmetricTensor<2, 3, Number> stress;
      for (unsigned int i = 0; i < dim; ++i)
        {
          stress[i][i] = shear * (strain[i][i] - mean) -
                         along_normal * normal[i][i] - along_flow * flow[i][i];
          for (unsigned int j = i + 1; j < dim; ++j)
            stress[i][j] = shear * strain[i][j] - along_normal * normal[i][j] -
                           along_flow * flow[i][j];
        }
      if (dim == 2)
        stress[2][2] = -(stress[0][0] + stress[1][1]);
      return stress;
    }

    /// The smallest eigenvalue of the symmetric one, a - (m : l + |m| |l|) / 2.
    Number
    smallest_eigenvalue() const
    {
      return shear -
             0.5 * (product(normal, flow) +
                    std::sqrt(product(normal, normal) * product(flow, flow)));
    }

  private:
    using Deviator = SymmetricTensor<2, dim, Number>;

    /// The product of two deviators of which these are the in-plane parts.
    static Number
    product(const Deviator &a, const Deviator &b)
    {
      return dim == 3 ? a * b : a * b + trace(a) * trace(b);
    }

    /// The product of a @p deviator with a strain. (In two dimensions, there is
    /// no shear out of plane.)
    ELASTO_PLASTIC_ALWAYS_INLINE static inline Number
    contraction(const SymmetricTensor<2, dim, Number> &deviator,
                const SymmetricTensor<2, 3, Number>   &strain)
    {
      Number normal = 0., shear = 0.;
      for (unsigned int i = 0; i < dim; ++i)
        {
          normal += deviator[i][i] *
                    (dim == 3 ? strain[i][i] : strain[i][i] - strain[2][2]);
          for (unsigned int j = i + 1; j < dim; ++j)
            shear += deviator[i][j] * strain[i][j];
        }
      return normal + 2. * shear;
    }
  };



  /// A tangent whose flow direction q, not longer than 1, is still open: the
  /// flow of the DeviatoricTangent will be flow_length q + recovery. If q is
  /// the direction of the flow at this strain, it is the consistent tangent.
  template <typename Number>
  struct OpenTangent
  {
    using Tensor3 = SymmetricTensor<2, 3, Number>;

    Number  shear;
    Tensor3 normal;
    /// sqrt(2 G theta_bar), or minus sqrt(-2 G theta_bar) where hardening has
    /// become so much steeper that the flow direction is stiff.
    Number flow_length;
    /// omega z'_perp / flow_length, zero without recovery.
    Tensor3 recovery;

    DeviatoricTangent<3, Number>
    with_flow(const Tensor3 &direction) const
    {
      return {shear, normal, flow_length * direction + recovery};
    }
  };
} // namespace ElastoPlastic

#endif
