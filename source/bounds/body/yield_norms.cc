// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/body/yield_norms.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The sum of q dq/db x b over the deviators b of an orthonormal basis.
    SymmetricTensor<4, 3>
    flow_of_stress(const HillCriterion &hill)
    {
      std::array<SymmetricTensor<2, 3>, 5> basis;
      basis[0][0][0] = std::sqrt(0.5);
      basis[0][1][1] = -std::sqrt(0.5);
      basis[1][0][0] = basis[1][1][1] = std::sqrt(1. / 6.);
      basis[1][2][2]                  = -std::sqrt(2. / 3.);
      basis[2][0][1] = basis[3][0][2] = basis[4][1][2] = std::sqrt(0.5);
      SymmetricTensor<4, 3> sum;
      for (const auto &b : basis)
        {
          const HillCriterion::Relaxation at_b(hill, b);
          sum += outer_product(at_b.equivalent_stress() * at_b.normal(), b);
        }
      return sum;
    }



    /// sym(n x v) in space.
    template <int dim>
    SymmetricTensor<2, 3>
    rate_of_slip(const Tensor<1, dim> &normal, const Tensor<1, dim> &slip)
    {
      SymmetricTensor<2, 3> rate;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          rate[i][j] = 0.5 * (normal[i] * slip[j] + normal[j] * slip[i]);
      return rate;
    }
  } // namespace



  double
  stress_norm(const Material<double>      &material,
              const SymmetricTensor<2, 3> &stress)
  {
    if (!has_general_criterion(material))
      return deviator(stress).norm();
    return std::sqrt(2. / 3.) * std::get<HillCriterion>(*material.criteria[0])
                                  .equivalent_stress(deviator(stress));
  }



  RateNorm::RateNorm(const Material<double> &material)
    : material(material)
  {
    // (With any multiple of the identity for pressures, it has an inverse.)
    if (has_general_criterion(material))
      stress_of_flow = invert(
        flow_of_stress(std::get<HillCriterion>(*material.criteria[0])) +
        outer_product(unit_symmetric_tensor<3>(), unit_symmetric_tensor<3>()));
  }



  double
  RateNorm::operator()(const SymmetricTensor<2, 3> &rate) const
  {
    if (!has_general_criterion(material) || rate.norm() == 0.)
      return rate.norm();
    const SymmetricTensor<2, 3> stress = stress_of_flow * deviator(rate);
    return (stress * deviator(rate)) / stress_norm(material, stress);
  }



  template <int dim>
  SlipNorm<dim>::SlipNorm(const SplitBody<dim> &body, const unsigned int face)
    : normal(body.outward_normal(face))
  {
    const auto &of_face    = body.mesh.faces[face];
    bool        is_general = false;
    for (unsigned int i = 0; i < of_face.n_neighbors(); ++i)
      {
        const auto &material = body.materials[of_face.neighbors[i]];
        neighbors.push_back({material.yield_radius / body.shear_strength(face),
                             RateNorm(material)});
        is_general = is_general || has_general_criterion(material);
      }
    if (!is_general)
      neighbors.clear();
  }



  template <int dim>
  double
  SlipNorm<dim>::operator()(const Tensor<1, dim> &slip) const
  {
    if (neighbors.empty())
      return slip.norm();
    const auto rate = rate_of_slip<dim>(normal, slip);
    double     work = std::numeric_limits<double>::max();
    for (const auto &[strength, norm] : neighbors)
      work = std::min(work, strength * norm(rate));
    return work;
  }



  template class SlipNorm<2>;
  template class SlipNorm<3>;
} // namespace ElastoPlastic
