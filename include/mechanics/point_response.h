// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_point_response_h
#define mechanics_point_response_h

#include "base/simd.h"
#include "material/radial_return.h"

namespace ElastoPlastic
{
  /// The mean stress: what belongs to the volumetric strain or, in a sheet,
  /// where that is not known, what together with the @p deviatoric_stress
  /// leaves no stress out of plane.
  template <typename Number>
  ELASTO_PLASTIC_ALWAYS_INLINE inline Number
  mean_stress(const bool                           is_sheet,
              const Number                        &volumetric_stress,
              const SymmetricTensor<2, 3, Number> &deviatoric_stress)
  {
    return is_sheet ? Number(-deviatoric_stress[2][2]) : volumetric_stress;
  }



  /// A material point at the end of a load step: all that residual, energy,
  /// output and evaluation want to know of it. Energies and works are per unit
  /// of volume.
  template <typename Number>
  class PointResponse
  {
  public:
    using Tensor3 = SymmetricTensor<2, 3, Number>;

    /// @p strain is the total strain, also out of plane; of its trace
    /// @p volumetric_strain takes the place. @p material must outlive this
    /// object.
    PointResponse(const bool                   is_sheet,
                  const Material<Number>      &material,
                  const Tensor3               &strain,
                  const Number                &volumetric_strain,
                  const MaterialState<Number> &old_state)
      : law(material, strain_deviator(strain), old_state)
      , bulk_modulus(material.bulk_modulus)
      , total_stress(law.deviatoric_stress())
      , pressure(mean_stress(is_sheet,
                             Number(bulk_modulus * volumetric_strain),
                             total_stress))
    {
      for (unsigned int d = 0; d < 3; ++d)
        total_stress[d][d] += pressure;
    }

    const Tensor3 &
    stress() const
    {
      return total_stress;
    }

    Number
    elastic_energy() const
    {
      return law.distortion_energy() + volumetric_energy();
    }

    /// The incremental potential of the stress. Where there is none
    /// (ElastoPlastic::has_potential()): the elastic energy and the plastic
    /// work of the step, to look at.
    Number
    incremental_energy(const bool has_potential) const
    {
      return volumetric_energy() +
             (has_potential ? law.energy() :
                              law.distortion_energy() + law.plastic_work());
    }

    /// Everything that has to do with plasticity.
    const RadialReturn<Number> &
    plasticity() const
    {
      return law;
    }

  private:
    Number
    volumetric_energy() const
    {
      return 0.5 * pressure * pressure / bulk_modulus;
    }

    const RadialReturn<Number> law;
    const Number               bulk_modulus;
    Tensor3                    total_stress;
    const Number               pressure;
  };
} // namespace ElastoPlastic

#endif
