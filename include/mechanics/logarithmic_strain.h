// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_logarithmic_strain_h
#define mechanics_logarithmic_strain_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <limits>

#include "mechanics/logarithm.h"
#include "mechanics/principal_frame.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The logarithmic strain E = ln(F^T F) / 2 of the deformation gradient F = 1
  /// + grad u, and what follows from it @cite miehe_apel_lambrecht_2002: a
  /// material law made for small strains gives the stress T conjugate to E,
  /// and T the nominal (first Piola-Kirchhoff) stress P = T : dE/dF and its
  /// derivative (doc/theory, "Finite strain"). Number is double, or a batch
  /// of them.
  ///
  /// In the principal frame of C = F^T F = sum_a (1 + c_a) N_a N_a^T, with the
  /// vectors m_a = F N_a and the divided differences f of HalfLogarithm, and G
  /// = F^T dF + dF^T F,
  ///   dE_ab = f[a,b] G_ab,   S_ab = 2 f[a,b] T_ab,   P = F S,
  ///   T : d2E[H, G] = 2 sum_abc T_ab f[a,b,c] H_ac G_bc.
  template <int dim, typename Number>
  class LogarithmicStrain
  {
  public:
    using Matrix  = Tensor<2, 3, Number>;
    using Tensor3 = SymmetricTensor<2, 3, Number>;

    LogarithmicStrain() = default;

    /// @p gradient is that of the displacement; in two dimensions, nothing
    /// turns out of the plane.
    explicit LogarithmicStrain(const Matrix &gradient)
      : frame(cauchy_green_strain(gradient))
    {
      Matrix deformation = gradient;
      for (unsigned int d = 0; d < 3; ++d)
        deformation[d][d] += 1.;
      jacobian   = determinant(deformation);
      directions = deformation * frame.vectors;
      sharpen_small_stretches();
      for (unsigned int a = 0; a < 3; ++a)
        {
          // (a body that has been turned inside out has no strain)
          logarithms[a] = compare_and_apply_mask<SIMDComparison::greater_than>(
            jacobian,
            Number(0.),
            HalfLogarithm::value(frame.values[a]),
            Number(std::numeric_limits<double>::quiet_NaN()));
          for (unsigned int b = 0; b <= a; ++b)
            f_1[a][b] =
              HalfLogarithm::difference(frame.values[a], frame.values[b]);
        }
    }

    /// E; not a number if the determinant of F is not positive.
    Tensor3
    strain() const
    {
      Tensor3 diagonal;
      for (unsigned int a = 0; a < 3; ++a)
        diagonal[a][a] = logarithms[a];
      return frame.from_principal(diagonal);
    }

    /// tr E = ln det F
    Number
    volumetric() const
    {
      return logarithms[0] + logarithms[1] + logarithms[2];
    }

    /// Of the volumetric strain, with respect to F: F^-T.
    Matrix
    volumetric_slope() const
    {
      Matrix scaled;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int a = 0; a < 3; ++a)
          scaled[i][a] = directions[i][a] / (1. + frame.values[a]);
      return scaled * transpose(frame.vectors);
    }

    /// P, for the conjugate @p stress.
    Matrix
    nominal_stress(const Tensor3 &stress) const
    {
      return directions * Matrix(second_stress(frame.to_principal(stress))) *
             transpose(frame.vectors);
    }

    /// The true (Cauchy) stress P F^T / det F. (In a sheet, whose thickness the
    /// material law changes, F leaves that alone.)
    Tensor3
    true_stress(const Tensor3 &stress) const
    {
      const Tensor3 second = second_stress(frame.to_principal(stress));
      return symmetrize(directions * Matrix(second) * transpose(directions)) /
             jacobian;
    }

    /// The derivative of the nominal stress at a given stress T.
    class Tangent
    {
    public:
      /// @p strain must outlive this object.
      Tangent(const LogarithmicStrain &strain, const Tensor3 &stress)
        : strain(strain)
        , stress(strain.frame.to_principal(stress))
        , second_stress(strain.second_stress(this->stress))
      {
        const auto &values = strain.frame.values;
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b <= a; ++b)
            for (unsigned int c = 0; c <= b; ++c)
              f_2[a][b][c] =
                HalfLogarithm::difference(values[a], values[b], values[c]);
      }

      /// dP for the increment @p dF, where dT = law(dE).
      template <typename Law>
      Matrix
      operator()(const Matrix &dF, const Law &law) const
      {
        const Matrix &m = strain.directions;
        const Matrix  x = dF * strain.frame.vectors;
        const Tensor3 G = 2. * symmetrize(transpose(m) * x);

        Tensor3 dE;
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b <= a; ++b)
            dE[a][b] = strain.f_1[a][b] * G[a][b];
        const Tensor3 dT =
          strain.frame.to_principal(law(strain.frame.from_principal(dE)));

        Tensor3 dS;
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b <= a; ++b)
            {
              dS[a][b] = 2. * strain.f_1[a][b] * dT[a][b];
              for (unsigned int c = 0; c < 3; ++c)
                dS[a][b] += 2. * second_difference(a, b, c) *
                            (stress[a][c] * G[c][b] + stress[b][c] * G[c][a]);
            }
        return (m * Matrix(dS) + x * Matrix(second_stress)) *
               transpose(strain.frame.vectors);
      }

    private:
      const Number &
      second_difference(unsigned int a, unsigned int b, unsigned int c) const
      {
        if (a < b)
          std::swap(a, b);
        if (b < c)
          std::swap(b, c);
        if (a < b)
          std::swap(a, b);
        return f_2[a][b][c];
      }

      const LogarithmicStrain &strain;
      const Tensor3            stress, second_stress;
      /// f[a, b, c] for a >= b >= c
      Number f_2[3][3][3];
    };

  private:
    /// C - 1, without cancellation.
    static Tensor3
    cauchy_green_strain(const Matrix &gradient)
    {
      return 2. * symmetrize(gradient) +
             symmetrize(transpose(gradient) * gradient);
    }

    /// Small stretches are lost among the digits of large ones in C, but not in
    /// F.
    void
    sharpen_small_stretches()
    {
      for (unsigned int a = 0; a < 3; ++a)
        {
          Number square = 0.;
          for (unsigned int i = 0; i < 3; ++i)
            square += directions[i][a] * directions[i][a];
          frame.values[a] = compare_and_apply_mask<SIMDComparison::less_than>(
            frame.values[a], Number(-0.5), square - 1., frame.values[a]);
        }
    }

    /// S of T, both in the principal frame.
    Tensor3
    second_stress(const Tensor3 &stress) const
    {
      Tensor3 second;
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b <= a; ++b)
          second[a][b] = 2. * f_1[a][b] * stress[a][b];
      return second;
    }

    PrincipalFrame<dim, Number> frame;
    Number                      jacobian;
    /// m_a, as columns.
    Matrix                directions;
    std::array<Number, 3> logarithms;
    Tensor3               f_1;
  };
} // namespace ElastoPlastic

#endif
