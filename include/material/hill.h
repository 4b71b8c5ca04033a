// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_hill_h
#define material_hill_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The ratios R_11, R_22, R_33, R_12, R_13, R_23 of Hill's criterion: the
  /// yield stress in tension along an axis of the material, or sqrt(3) times
  /// that in shear between two of them, over sigma_Y. All ones are von Mises.
  using HillRatios = std::array<double, 6>;



  /// The equivalent stress q of Hill's quadratic criterion @cite hill_1948,
  ///
  ///   q^2 = F (s_22 - s_33)^2 + G (s_33 - s_11)^2 + H (s_11 - s_22)^2
  ///       + 2 L s_23^2 + 2 M s_13^2 + 2 N s_12^2
  ///
  /// in the axes of the material, a norm of the stress deviator. It is kept as
  /// q^2 = sum_i p_i (E_i : s)^2, with five deviators E_i, each of the norm 1
  /// and perpendicular to the others.
  class HillCriterion
  {
  public:
    using Tensor3 = SymmetricTensor<2, 3>;

    /// The columns of the rotation @p axes are the axes of the material, in the
    /// coordinates of the body. The ratios must be are_convex().
    HillCriterion(const HillRatios &ratios, const Tensor<2, 3> &axes);

    /// Whether q is a norm: the ratios are positive, and 1 / R_11, 1 / R_22 and
    /// 1 / R_33 the sides of a triangle, which is F G + G H + H F > 0. A
    /// hundredth of the longest side is left to the bound.
    static bool
    are_convex(const HillRatios &ratios);

    /// q
    double
    equivalent_stress(const Tensor3 &deviator) const
    {
      return Relaxation(*this, deviator).equivalent_stress();
    }

    /// Whether no in-plane stress belongs to shear between the third axis of
    /// the body and others: that is an axis of the material.
    bool
    has_third_axis() const;

    /// The stresses z(t) with z + t q(z) dq/dz = xi, of one trial stress xi:
    /// they minimise |z - xi|^2 / 2 + t q(z)^2 / 2.
    class Relaxation
    {
    public:
      /// @p criterion must outlive this object.
      Relaxation(const HillCriterion &criterion, const Tensor3 &trial);

      /// Sets t >= 0, which is 0 at first.
      void
      set_ratio(const double t)
      {
        ratio = t;
      }

      /// q(z)
      double
      equivalent_stress() const;

      /// n = dq/dz
      Tensor3
      normal() const;

      /// dz/dxi, of deviators; zero for multiples of the identity.
      SymmetricTensor<4, 3>
      derivative() const;

    private:
      const HillCriterion  &criterion;
      std::array<double, 5> trial;
      double                ratio = 0;
    };

  private:
    std::array<double, 5>  weights;      ///< p_i, 3/2 for von Mises
    std::array<Tensor3, 5> eigentensors; ///< E_i
  };
} // namespace ElastoPlastic

#endif
