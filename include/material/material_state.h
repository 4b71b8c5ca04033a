// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_material_state_h
#define material_material_state_h

#include <deal.II/base/symmetric_tensor.h>

#include "material/material.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What a material point remembers of its past. Tensors are deviatoric and
  /// three-dimensional, also in plane problems.
  template <typename Number>
  struct MaterialState
  {
    using Tensor3 = SymmetricTensor<2, 3, Number>;

    /// A virgin point.
    explicit MaterialState(const unsigned int n_back_stresses)
      : back_stresses(n_back_stresses)
    {}

    Tensor3 plastic_strain;
    /// alpha, with the rate sqrt(2/3) |plastic strain rate|.
    Number equivalent_plastic_strain = Number(0.);
    /// beta_1, beta_2, ...
    boost::container::static_vector<Tensor3, max_back_stresses> back_stresses;

    /// The size of a state as an array.
    static constexpr unsigned int
    n_values(const unsigned int n_back_stresses)
    {
      return 7 + 6 * n_back_stresses;
    }

    /// Whether it is that of a virgin point, in all lanes.
    bool
    is_virgin() const
    {
      std::array<Number, n_values(max_back_stresses)> values;
      pack(values.data());
      for (unsigned int i = 0; i < n_values(back_stresses.size()); ++i)
        for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
          if (lane_of(values[i], lane) != 0.)
            return false;
      return true;
    }

    /// Writes all numbers to an array.
    void
    pack(Number *values) const
    {
      values    = pack_tensor(plastic_strain, values);
      *values++ = equivalent_plastic_strain;
      for (const Tensor3 &back_stress : back_stresses)
        values = pack_tensor(back_stress, values);
    }

    /// Reads all numbers from an array.
    void
    unpack(const Number *values)
    {
      values                    = unpack_tensor(plastic_strain, values);
      equivalent_plastic_strain = *values++;
      for (Tensor3 &back_stress : back_stresses)
        values = unpack_tensor(back_stress, values);
    }

  private:
    static Number *
    pack_tensor(const Tensor3 &tensor, Number *values)
    {
      for (unsigned int i = 0; i < 6; ++i)
        *values++ = tensor.access_raw_entry(i);
      return values;
    }

    static const Number *
    unpack_tensor(Tensor3 &tensor, const Number *values)
    {
      for (unsigned int i = 0; i < 6; ++i)
        tensor.access_raw_entry(i) = *values++;
      return values;
    }
  };



  /// Brings a state that interpolation has made back to those that a history of
  /// the material can lead to: alpha >= 0 and |beta_k| <= c_k / g_k, as an
  /// Armstrong-Frederick law leaves it. What differs from them by rounding only
  /// stays as it is.
  template <typename Number>
  void
  make_admissible(MaterialState<Number>  &state,
                  const Material<Number> &material)
  {
    state.equivalent_plastic_strain =
      std::max(state.equivalent_plastic_strain, Number(0.));
    for (unsigned int k = 0; k < state.back_stresses.size(); ++k)
      {
        const auto &[modulus, recovery] = material.back_stresses[k];
        // (without a modulus, there is neither recovery nor back stress)
        const Number ratio = recovery * state.back_stresses[k].norm() /
                             std::max(modulus, Number(1e-100));
        state.back_stresses[k] /=
          compare_and_apply_mask<SIMDComparison::greater_than>(
            ratio, Number(1. + 1e-12), ratio, Number(1.));
      }
  }



  /// The strain (or another tensor) of one lane.
  template <typename Number>
  SymmetricTensor<2, 3>
  lane_of(const SymmetricTensor<2, 3, Number> &tensor, const unsigned int lane)
  {
    SymmetricTensor<2, 3> result;
    for (unsigned int i = 0; i < 6; ++i)
      result.access_raw_entry(i) = lane_of(tensor.access_raw_entry(i), lane);
    return result;
  }



  /// The state of one lane.
  template <typename Number>
  MaterialState<double>
  lane_of(const MaterialState<Number> &state, const unsigned int lane)
  {
    MaterialState<double> result(state.back_stresses.size());
    result.plastic_strain = lane_of(state.plastic_strain, lane);
    result.equivalent_plastic_strain =
      lane_of(state.equivalent_plastic_strain, lane);
    for (unsigned int k = 0; k < state.back_stresses.size(); ++k)
      result.back_stresses[k] = lane_of(state.back_stresses[k], lane);
    return result;
  }
} // namespace ElastoPlastic

#endif
