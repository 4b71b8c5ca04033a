// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_hencky_material_h
#define bounds_body_hencky_material_h

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>
#include <vector>

#include "base/kinematics.h"
#include "bounds/body/yield_norms.h"
#include "material/material.h"

/// A material in one step from the virgin state, with linear hardening: the
/// deformation theory of Hencky. Its energy and complementary energy are
///   W(eps)  = min over e_p of 1/2 (eps - e_p) : C (eps - e_p) + R |e_p|
///                             + h/2 |e_p|^2,
///   W*(tau) = min over zeta of 1/2 tau : C^-1 tau + zeta^2 / (2 h)
///                             with |dev tau| <= R + zeta,
/// R being the yield radius. Isotropic and kinematic hardening are the same.
/// With Hill's criterion, the norm of e_p is RateNorm, that of dev tau is
/// stress_norm(), and hardening is isotropic.
namespace ElastoPlastic::HenckyMaterial
{
  using namespace dealii;

  inline bool
  yields(const Material<double> &material)
  {
    return std::isfinite(material.yield_radius);
  }

  /// h = 2/3 (H + H_k)
  double
  hardening(const Material<double> &material);

  inline bool
  hardens(const Material<double> &material)
  {
    return yields(material) && hardening(material) > 0;
  }

  /// With what the equilibrium method computes, to be of the order 1.
  struct Units
  {
    double stress; ///< the smallest yield radius, or a modulus of elasticity
    double strain; ///< this stress by Young's modulus
  };

  Units
  units_of(const std::vector<Material<double>> &materials);

  /// C^-1 tau
  SymmetricTensor<2, 3>
  compliance(const Material<double>      &material,
             const SymmetricTensor<2, 3> &stress);

  /// eps : C eps
  double
  elastic_product(const Material<double>      &material,
                  const SymmetricTensor<2, 3> &strain);

  /// An elastic and a plastic part.
  struct Strain
  {
    SymmetricTensor<2, 3> elastic;
    SymmetricTensor<2, 3> plastic;
  };

  /// The parts of a strain, by the minimum in W.
  Strain
  split_strain(const Material<double>      &material,
               const SymmetricTensor<2, 3> &strain);

  /// The strain of a section: in a sheet, with the component out of plane that
  /// leaves no stress there, whatever that of @p strain is; otherwise @p
  /// strain.
  SymmetricTensor<2, 3>
  strain_of_section(const Material<double>      &material,
                    const SymmetricTensor<2, 3> &strain,
                    const Kinematics             kinematics);

  /// At least W(eps) + W*(tau) - tau : eps, but for the term R |e_p|, for any
  /// plastic strain e_p and any zeta of the stress. Its two parts, with
  /// d = eps - e_p - C^-1 tau, are
  ///   1/2 d : C d and h/2 |e_p|^2 + zeta^2 / (2 h) - tau : e_p.
  /// @p norm is that of plastic strains.
  double
  quadratic_gap(const Material<double>      &material,
                const RateNorm              &norm,
                const SymmetricTensor<2, 3> &strain,
                const SymmetricTensor<2, 3> &plastic_strain,
                const SymmetricTensor<2, 3> &stress,
                const double                 zeta);
} // namespace ElastoPlastic::HenckyMaterial

#endif
