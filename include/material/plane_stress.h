// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_plane_stress_h
#define material_plane_stress_h

#include "material/flow_stress.h"
#include "material/material_state.h"

namespace ElastoPlastic
{
  /// One backward Euler step of J2 plasticity in plane stress, at one point.
  /// The strain across the sheet follows from the multiplier without iteration,
  /// and the multiplier from one scalar equation (doc/theory, "Plane
  /// stress"), as in the projected return mapping @cite simo_taylor_1986. With
  /// this strain, the return mapping for bodies in space (RadialReturn) leads
  /// to the same state, and to no stress across the sheet.
  class PlaneStressReturn
  {
  public:
    /// @p strain is that at the end of the step, with any value across the
    /// sheet, @p old_state the state at its beginning. All arguments must
    /// outlive this object.
    PlaneStressReturn(const Material<double>      &material,
                      const SymmetricTensor<2, 3> &strain,
                      const MaterialState<double> &old_state)
      : material(material)
      , strain(strain)
      , old_state(old_state)
      , resistance(material, old_state.equivalent_plastic_strain, 0)
    {}


    /// The strain across the sheet; not a number if there is no solution, as
    /// for numbers beyond the range of the computer's.
    double
    out_of_plane_strain() const;

  private:
    using Flow = FlowResistance::Value;

    /// The sum of the old back stresses, as far as the recovery leaves them.
    SymmetricTensor<2, 3>
    back_stress(const double multiplier) const;

    /// The strain across the sheet for which there is no stress across it.
    double
    out_of_plane_strain(const Flow &flow) const;

    /// By how much the norm of the relative stress exceeds the resistance.
    double
    excess(const Flow &flow) const;

    const Material<double>      &material;
    const SymmetricTensor<2, 3> &strain;
    const MaterialState<double> &old_state;
    const FlowResistance         resistance;
  };



  /// The same for all lanes of a VectorizedArray.
  template <typename Number>
  Number
  out_of_plane_strain(const Material<Number>              &material,
                      const SymmetricTensor<2, 3, Number> &strain,
                      const MaterialState<Number>         &old_state)
  {
    Number result;
    for (unsigned int lane = 0; lane < n_lanes<Number>; ++lane)
      lane_of(result, lane) = PlaneStressReturn(lane_of(material, lane),
                                                lane_of(strain, lane),
                                                lane_of(old_state, lane))
                                .out_of_plane_strain();
    return result;
  }
} // namespace ElastoPlastic

#endif
