// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_logarithmic_strain_h
#define mechanics_logarithmic_strain_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <limits>

#include "mechanics/displacement_gradient.h"
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
          f_1[a][a] = HalfLogarithm::slope(frame.values[a]);
          for (unsigned int b = 0; b < a; ++b)
            if (number_of_pair(a, b) < n_pairs)
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

    /// The derivative of the nominal stress at a given stress T, where dT =
    /// law(dE). As G_aa = 2 B_aa : dF and G_ab = B_ab : dF, where B_aa = m_a
    /// N_a^T and B_ab = m_a N_b^T + m_b N_a^T,
    ///   dP = sum_(a <= b) dS_ab B_ab + dF S.
    template <typename Law>
    Tensor<2, n_gradient_entries<dim>, Number>
    nominal_tangent(const Tensor3 &stress, const Law &law) const
    {
      constexpr unsigned int n          = n_gradient_entries<dim>;
      const Tensor3          of_frame   = frame.to_principal(stress);
      const PairMatrix       stiffness  = second_stress_tangent(of_frame, law);
      const auto             conjugates = conjugate_directions();
      const Tensor3 second = frame.from_principal(second_stress(of_frame));

      Tensor<2, n, Number> result;
      for (unsigned int l = 0; l < n; ++l)
        {
          for (unsigned int p = 0; p < n_pairs; ++p)
            {
              Number slope = Number(0.);
              for (unsigned int q = 0; q < n_pairs; ++q)
                slope += stiffness[p][q] * conjugates[q][l];
              for (unsigned int k = 0; k < n; ++k)
                result[k][l] += conjugates[p][k] * slope;
            }
          for (unsigned int k = 0; k < n; ++k)
            if (place_of_entry<dim>(k)[0] == place_of_entry<dim>(l)[0])
              result[k][l] +=
                second[place_of_entry<dim>(k)[1]][place_of_entry<dim>(l)[1]];
        }
      return result;
    }

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

    /// The pairs a <= b of principal directions, in the order of
    /// SymmetricTensor; in two dimensions those that do not turn out of the
    /// plane, which come first.
    static constexpr unsigned int n_pairs = (dim == 2 ? 4 : 6);

    using PairMatrix = std::array<std::array<Number, n_pairs>, n_pairs>;

    static constexpr std::array<unsigned int, 2>
    pair(const unsigned int p)
    {
      if (p < 3)
        return {{p, p}};
      return {{p / 5, p == 3 ? 1u : 2u}};
    }

    static constexpr unsigned int
    number_of_pair(const unsigned int a, const unsigned int b)
    {
      return a == b ? a : a + b + 2;
    }

    /// The B_ab.
    std::array<GradientEntries<dim, Number>, n_pairs>
    conjugate_directions() const
    {
      std::array<GradientEntries<dim, Number>, n_pairs> result;
      for (unsigned int p = 0; p < n_pairs; ++p)
        {
          const auto [a, b] = pair(p);
          for (unsigned int k = 0; k < n_gradient_entries<dim>; ++k)
            {
              const auto [i, j] = place_of_entry<dim>(k);
              result[p][k]      = directions[i][a] * frame.vectors[j][b];
              if (a != b)
                result[p][k] += directions[i][b] * frame.vectors[j][a];
            }
        }
      return result;
    }

    /// dS_ab over B_cd : dF, at the @p stress T in the principal frame.
    template <typename Law>
    PairMatrix
    second_stress_tangent(const Tensor3 &stress, const Law &law) const
    {
      std::array<Tensor3, n_pairs> dE;
      for (unsigned int p = 0; p < n_pairs; ++p)
        {
          const auto [a, b] = pair(p);
          const auto &N     = frame.vectors;
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j <= i; ++j)
              dE[p][i][j] = f_1[a][b] * (N[i][a] * N[j][b] + N[i][b] * N[j][a]);
        }
      PairMatrix result;
      for (unsigned int q = 0; q < n_pairs; ++q)
        {
          const Tensor3 dT = law(dE[q]);
          for (unsigned int p = 0; p < n_pairs; ++p)
            result[p][q] = dE[p] * dT;
        }
      add_curvature(result, stress);
      return result;
    }

    /// T : d2E[G, G], as a quadratic form of the B_ab : dF.
    void
    add_curvature(PairMatrix &form, const Tensor3 &stress) const
    {
      const std::array<Tensor3, 3> f_2 = second_differences();
      for (unsigned int p = 0; p < n_pairs; ++p)
        {
          const auto [a, b] = pair(p);
          for (unsigned int c = 0; c < 3; ++c)
            {
              if (const unsigned int q = number_of_pair(c, b); q < n_pairs)
                form[p][q] += (c == b ? 4. : 2.) * f_2[a][b][c] * stress[a][c];
              if (const unsigned int q = number_of_pair(c, a); q < n_pairs)
                form[p][q] += (c == a ? 4. : 2.) * f_2[a][b][c] * stress[b][c];
            }
        }
    }

    /// f[a,b,c]; in two dimensions, those in the plane and out of it.
    std::array<Tensor3, 3>
    second_differences() const
    {
      std::array<Tensor3, 3> f_2;
      const auto            &values = frame.values;
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b <= a; ++b)
          for (unsigned int c = 0; c <= b; ++c)
            if (dim == 3 || a < 2 || c == 2)
              f_2[a][b][c] = f_2[b][a][c] = f_2[c][a][b] =
                (a == c ?
                   HalfLogarithm::half_curvature(values[a]) :
                   HalfLogarithm::difference(values[a], values[b], values[c]));
      return f_2;
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
