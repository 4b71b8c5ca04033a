// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_yield_norms_h
#define bounds_body_yield_norms_h

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

#include "bounds/body/split_body.h"

// What the yield criterion of a material says of stresses and velocities that
// have been found, for the checks of them: from the criterion itself, while
// programs have the matrices of bounds/body/yield_matrices.h.

namespace ElastoPlastic
{
  /// What the yield condition compares with the yield radius sqrt(2/3) sigma_0:
  /// the norm of the deviator, or sqrt(2/3) q with Hill's equivalent stress q.
  double
  stress_norm(const Material<double>      &material,
              const SymmetricTensor<2, 3> &stress);



  /// The plastic work of strain rates e that change no volume, over the yield
  /// radius: the largest s : e of all stresses s with the stress_norm() 1. That
  /// is |e|, or with Hill's criterion what the stress with the flow e does.
  class RateNorm
  {
  public:
    /// @p material must outlive this object.
    explicit RateNorm(const Material<double> &material);

    double
    operator()(const SymmetricTensor<2, 3> &rate) const;

  private:
    const Material<double> &material;
    /// The inverse of s -> q dq/ds, of deviators; not used without a criterion.
    SymmetricTensor<4, 3> stress_of_flow;
  };



  /// The plastic work of a slip along a face, over the yield stress in shear
  /// SplitBody::shear_strength(): that of the rate sym(n x slip) in the
  /// neighbour in which it is less. It is |slip| with von Mises' criterion.
  template <int dim>
  class SlipNorm
  {
  public:
    /// @p body must outlive this object.
    SlipNorm(const SplitBody<dim> &body, const unsigned int face);

    double
    operator()(const Tensor<1, dim> &slip) const;

  private:
    struct Neighbor
    {
      double   strength; ///< yield radius by shear_strength()
      RateNorm norm;
    };

    const Tensor<1, dim>  normal;
    std::vector<Neighbor> neighbors; ///< none where all are von Mises'
  };
} // namespace ElastoPlastic

#endif
