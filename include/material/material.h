// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_material_h
#define material_material_h

namespace ElastoPlastic
{
  /// The constants of an isotropic elasto-plastic material with linear
  /// hardening, in the form the radial return needs them: all of them are
  /// stresses. @p Number is double, or a VectorizedArray when the cells of a
  /// batch consist of different materials.
  template <typename Number>
  struct Material
  {
    /// K = E / (3 (1 - 2 nu))
    Number bulk_modulus;
    /// G = E / (2 (1 + nu))
    Number shear_modulus;
    /// sqrt(2/3) sigma_0, the radius of the virgin yield surface in the space
    /// of deviatoric stresses; infinite for an elastic material.
    Number yield_radius;
    /// 2/3 H: what the radius gains per unit of the plastic multiplier.
    Number isotropic_modulus;
    /// 2/3 H_k: Prager's modulus of the back stress.
    Number kinematic_modulus;
  };
} // namespace ElastoPlastic

#endif
