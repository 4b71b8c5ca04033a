// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_deviatoric_tangent_h
#define material_deviatoric_tangent_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/vectorization.h>

#include "base/tensors.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The deviatoric part of a tangent, de -> a de - (m (l : de) + l (m : de))/2
  /// with a = 2 G theta, where m and l are the normal of the yield surface and
  /// the flow direction, both times sqrt(2 G theta_bar); for the consistent
  /// tangent they are the same (doc/theory.md, "Material"). Back stresses that
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
    DEAL_II_ALWAYS_INLINE inline SymmetricTensor<2, 3, Number>
    product(const SymmetricTensor<2, 3, Number> &strain,
            const Number                        &share) const
    {
      const auto m      = normal_in_space();
      const auto l      = flow_in_space();
      auto       stress = elastic_product(strain);
      stress -= (share * (l * strain)) * m;
      stress -= ((Number(1.) - share) * (m * strain)) * l;
      return stress;
    }

  private:
    SymmetricTensor<2, 3, Number>
    normal_in_space() const
    {
      return in_space<dim>(normal, Number(-trace(normal)));
    }

    SymmetricTensor<2, 3, Number>
    flow_in_space() const
    {
      return in_space<dim>(flow, Number(-trace(flow)));
    }

    DEAL_II_ALWAYS_INLINE inline SymmetricTensor<2, 3, Number>
    elastic_product(const SymmetricTensor<2, 3, Number> &strain) const
    {
      const Number                  mean   = shear * trace(strain) * (1. / 3.);
      SymmetricTensor<2, 3, Number> stress = shear * strain;
      for (unsigned int d = 0; d < 3; ++d)
        stress[d][d] -= mean;
      return stress;
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
