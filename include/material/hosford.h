// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_hosford_h
#define material_hosford_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The equivalent stress q of Hosford's criterion @cite hosford_1972,
  ///
  ///   q^a = (|s_1 - s_2|^a + |s_2 - s_3|^a + |s_3 - s_1|^a) / 2
  ///
  /// with the principal stresses s_i and an exponent a >= 2. The exponents 2
  /// and 4 are von Mises, large ones tend to Tresca.
  class HosfordCriterion
  {
  public:
    using Tensor3 = SymmetricTensor<2, 3>;

    explicit HosfordCriterion(const double exponent)
      : exponent(exponent)
    {}

    /// q
    double
    equivalent_stress(const Tensor3 &deviator) const
    {
      return Relaxation(*this, deviator).equivalent_stress();
    }

    /// The stresses z(t) with z + t q(z) dq/dz = xi, of one trial stress xi,
    /// see HillCriterion::Relaxation. They have the principal axes of xi; with
    /// s_1 >= s_2 >= s_3, unknown is r = (z_1 - z_2) / (z_1 - z_3).
    class Relaxation
    {
    public:
      /// @p criterion must outlive this object.
      Relaxation(const HosfordCriterion &criterion, const Tensor3 &trial);

      void
      set_ratio(const double t);

      double
      equivalent_stress() const;

      Tensor3
      normal() const;

      SymmetricTensor<4, 3>
      derivative() const;

    private:
      /// The derivative of the principal values of z with respect to those of
      /// xi.
      Tensor<2, 3>
      principal_derivative() const;

      /// (z_i - z_j) / (xi_i - xi_j), what shear between two axes leaves.
      double
      turning(const Tensor<2, 3> &principal_derivative,
              const unsigned int  i,
              const unsigned int  j) const;

      const HosfordCriterion     &criterion;
      std::array<double, 3>       trial; ///< decreasing
      std::array<Tensor<1, 3>, 3> axes;
      double                      ratio = 0;
      double                      place = 0; ///< r
      double                      range = 0; ///< z_1 - z_3
    };

  private:
    /// What depends on r at the range z_1 - z_3 = 1.
    struct Shape
    {
      double equivalent; ///< q
      /// q (n_1 - n_3) and q (n_1 - n_2), and their derivatives.
      double across_all, across_first, across_all_slope, across_first_slope;
    };

    Shape
    shape(const double r) const;

    double exponent;
  };
} // namespace ElastoPlastic

#endif
