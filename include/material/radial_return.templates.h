// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_radial_return_templates_h
#define material_radial_return_templates_h

// What RadialReturn does lane by lane: with nonlinear laws, and with other
// criteria than that of von Mises.

#include "material/radial_return.h"

namespace ElastoPlastic
{
  template <typename Number>
  void
  RadialReturn<Number>::solve_return_equations(const Tensor3 &trial)
  {
    const unsigned int n_back_stresses = old_state.back_stresses.size();

    std::array<std::array<Number, max_back_stresses + 1>, max_back_stresses + 1>
      products;
    for (unsigned int i = 0; i <= n_back_stresses; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        products[i][j] = products[j][i] =
          (i == 0 ? trial : old_state.back_stresses[i - 1]) *
          (j == 0 ? trial : old_state.back_stresses[j - 1]);

    for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
      if (lane_of(multiplier, lane) > 0)
        {
          ReturnEquation equation = {
            FlowResistance(material, old_state.equivalent_plastic_strain, lane),
            {}};
          for (unsigned int i = 0; i <= n_back_stresses; ++i)
            for (unsigned int j = 0; j <= n_back_stresses; ++j)
              equation.products[i][j] = lane_of(products[i][j], lane);
          lane_of(multiplier, lane) = equation.solve();
        }
  }



  // (The norm becomes that of xi, so that the shear stiffness is the one
  // across the flow of a radial return.)
  template <typename Number>
  void
  RadialReturn<Number>::return_with_general_criteria(const Tensor3 &trial)
  {
    modulus    = kinematic_modulus();
    multiplier = Number(0.);
    for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
      {
        const FlowStress            stress(material,
                                old_state.equivalent_plastic_strain,
                                lane);
        const SymmetricTensor<2, 3> of_lane = lane_of(trial, lane);
        const auto [increment, normal] = GeneralReturn(*material.criteria[lane],
                                                       of_lane,
                                                       lane_of(modulus, lane),
                                                       stress)
                                           .flow();
        lane_of(relaxation, lane) =
          material.rate_laws[lane].relaxation(material.step_duration);
        if (increment == 0.)
          continue;
        const double length        = normal.norm();
        lane_of(multiplier, lane)  = increment * length;
        lane_of(equivalence, lane) = 1. / length;
        lane_of(modulus, lane) += stress.slope(increment) / (length * length);
        for (unsigned int i = 0; i < Tensor3::n_independent_components; ++i)
          lane_of(direction.access_raw_entry(i), lane) =
            normal.access_raw_entry(i) / length;
      }
  }



  // s = 2 G (e - w x n) with the relaxation w, and x n = (xi - z) / M.
  template <typename Number>
  SymmetricTensor<4, 3, Number>
  RadialReturn<Number>::general_tangent() const
  {
    const Number two_g = 2. * material.shear_modulus;
    Tensor3      trial = two_g * elastic_trial_strain;
    for (const Tensor3 &back_stress : old_state.back_stresses)
      trial -= back_stress;

    SymmetricTensor<4, 3, Number> result;
    for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
      {
        const double          stiffness = lane_of(two_g, lane);
        SymmetricTensor<4, 3> of_lane =
          stiffness * deviator_tensor<3, double>();
        if (lane_of(multiplier, lane) > 0.)
          {
            const FlowStress            stress(material,
                                    old_state.equivalent_plastic_strain,
                                    lane);
            const SymmetricTensor<2, 3> of_trial = lane_of(trial, lane);
            const double                m = lane_of(kinematic_modulus(), lane);
            const GeneralReturn         point(*material.criteria[lane],
                                      of_trial,
                                      m,
                                      stress);
            const double flowing = lane_of(relaxation, lane) * stiffness / m;
            of_lane              = (1. - flowing) * of_lane +
                      flowing * stiffness *
                        point.derivative(
                          lane_of(Number(equivalence * multiplier), lane));
          }
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = i; j < 3; ++j)
            for (unsigned int k = 0; k < 3; ++k)
              for (unsigned int l = k; l < 3; ++l)
                lane_of(result[i][j][k][l], lane) = of_lane[i][j][k][l];
      }
    return result;
  }
} // namespace ElastoPlastic

#endif
