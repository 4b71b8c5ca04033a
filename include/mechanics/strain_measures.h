// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_strain_measures_h
#define mechanics_strain_measures_h

#include "base/simd.h"
#include "mechanics/coordinates.h"
#include "mechanics/logarithmic_strain.h"
#include "mechanics/point_response.h"

namespace ElastoPlastic
{
  /// How the cell kernel makes strains of displacements, at a quadrature point
  /// of a batch of cells: small strains. What depends on the place only comes
  /// from the @p Coordinates. The other measures, below, have the same members.
  ///
  /// Small changes of a deformation are described by Increments, those of a
  /// small strain by strains; what is conjugate to them, and what nodal forces
  /// are made of, has the same type.
  template <typename Coordinates>
  struct SmallStrain : Coordinates
  {
    /// The measure that all with the same increments share, so that what only
    /// depends on these is compiled once.
    using OfIncrements = SmallStrain;

    /// Whether tangents are NominalTangents.
    static constexpr bool has_nominal_tangents = false;

    /// Whether there is a stress_of_mode(): gradients are those of BoxModes.
    static constexpr bool has_modes = Coordinates::n_slopes == Coordinates::dim;

    /// What is known of the deformation at a point.
    template <typename Number>
    struct Deformation
    {
      SymmetricTensor<2, 3, Number> strain;

      Number
      volumetric() const
      {
        return trace(strain);
      }
    };

    template <typename Evaluation>
    ELASTO_PLASTIC_ALWAYS_INLINE static auto
    deformation_at(const Evaluation &phi, const unsigned int point)
    {
      return Deformation<NumberOf<Evaluation>>{
        Coordinates::strain_at(phi, point)};
    }

    /// The conjugate of the stress that a material law has given.
    template <typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static const SymmetricTensor<2, 3, Number> &
    conjugate(const Deformation<Number> &,
              const SymmetricTensor<2, 3, Number> &stress)
    {
      return stress;
    }

    template <typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static const SymmetricTensor<2, 3, Number> &
    true_stress(const Deformation<Number> &,
                const SymmetricTensor<2, 3, Number> &stress)
    {
      return stress;
    }

    template <typename Evaluation>
    ELASTO_PLASTIC_ALWAYS_INLINE static auto
    increment_at(const Evaluation &phi, const unsigned int point)
    {
      return Coordinates::strain_at(phi, point);
    }

    template <typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static SymmetricTensor<2, 3, Number>
    increment_of_slopes(const Tensor<1, Coordinates::n_slopes, Number> &slopes,
                        const unsigned int component)
    {
      return Coordinates::strain_of_slopes(slopes, component);
    }

    /// How much an @p increment changes the volumetric strain. @p tangents are
    /// Tangents::OfBatch.
    template <typename TangentsOfBatch, typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static Number
    volumetric(const TangentsOfBatch &,
               const unsigned int,
               const SymmetricTensor<2, 3, Number> &increment)
    {
      return trace(increment);
    }

    /// The conjugate of an @p increment in the linear law of @p tangents; in a
    /// sheet, the strain becomes that for which there is no stress out of
    /// plane.
    template <typename TangentsOfBatch, typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static SymmetricTensor<2, 3, Number>
    linear_conjugate(const TangentsOfBatch               &tangents,
                     const unsigned int                   point,
                     const SymmetricTensor<2, 3, Number> &increment,
                     const Number                        &volumetric)
    {
      return linear_stress(tangents.law(point),
                           tangents.bulk_modulus,
                           increment,
                           volumetric);
    }

    /// The stress of the displacement gradient @p entries of a @p Mode, see
    /// BoxModes, with a tangent that is the same at all points. (What is
    /// zero in a gradient makes hardly a difference for small strains.)
    template <typename Mode, typename TangentsOfBatch, typename Entries>
    ELASTO_PLASTIC_ALWAYS_INLINE static Entries
    stress_of_mode(const TangentsOfBatch &tangents,
                   const Entries         &entries,
                   const bool             has_volumetric_strain)
    {
      constexpr int dim = Coordinates::dim;
      using Number      = typename Entries::value_type;
      SymmetricTensor<2, 3, Number> strain;
      for (unsigned int i = 0; i < dim; ++i)
        {
          strain[i][i] = entries[dim * i + i];
          for (unsigned int j = i + 1; j < dim; ++j)
            strain[i][j] = 0.5 * (entries[dim * i + j] + entries[dim * j + i]);
        }
      const auto stress =
        linear_conjugate(tangents,
                         0,
                         strain,
                         has_volumetric_strain ? trace(strain) : Number(0.));
      Entries result;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          result[dim * i + j] = stress[i][j];
      return result;
    }

    /// Hands in a @p conjugate, to be integrated against the increments that
    /// belong to the shape functions.
    template <typename Evaluation, typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static void
    submit(Evaluation                          &phi,
           const SymmetricTensor<2, 3, Number> &conjugate,
           const unsigned int                   point)
    {
      Coordinates::submit_stress(phi, conjugate, point);
    }

    template <typename Law, typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static SymmetricTensor<2, 3, Number>
    linear_stress(const Law                           &deviatoric_stress,
                  const Number                        &bulk_modulus,
                  const SymmetricTensor<2, 3, Number> &strain,
                  const Number                        &volumetric)
    {
      constexpr bool                is_sheet = Coordinates::is_sheet;
      SymmetricTensor<2, 3, Number> stress   = deviatoric_stress(strain);
      if constexpr (is_sheet)
        {
          SymmetricTensor<2, 3, Number> across;
          across[2][2]         = Number(1.);
          const auto of_across = deviatoric_stress(across);
          stress -= ((bulk_modulus * trace(strain) + stress[2][2]) /
                     (bulk_modulus + of_across[2][2])) *
                    of_across;
        }
      const Number pressure =
        mean_stress(is_sheet, Number(bulk_modulus * volumetric), stress);
      for (unsigned int d = 0; d < 3; ++d)
        stress[d][d] += pressure;
      return stress;
    }
  };



  /// Small changes of a finite deformation, whose tangents are NominalTangents:
  /// all that a level of multigrid needs.
  template <typename Coordinates>
  struct FiniteIncrement : SmallStrain<Coordinates>
  {
    static constexpr int dim = Coordinates::dim;

    using OfIncrements = FiniteIncrement<typename Coordinates::OfGradients>;

    static constexpr bool has_nominal_tangents = true;

    /// (In a plane body, gradients have an entry out of plane.)
    static constexpr bool has_modes = dim == 3;

    template <typename Evaluation>
    ELASTO_PLASTIC_ALWAYS_INLINE static auto
    increment_at(const Evaluation &phi, const unsigned int point)
    {
      return Coordinates::gradient_at(phi, point);
    }

    template <typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static GradientEntries<dim, Number>
    increment_of_slopes(const Tensor<1, Coordinates::n_slopes, Number> &slopes,
                        const unsigned int component)
    {
      return Coordinates::gradient_of_slopes(slopes, component);
    }

    template <typename TangentsOfBatch, typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static Number
    volumetric(const TangentsOfBatch              &tangents,
               const unsigned int                  point,
               const GradientEntries<dim, Number> &increment)
    {
      return tangents.volumetric_slope(point) * increment;
    }

    template <typename TangentsOfBatch, typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static GradientEntries<dim, Number>
    linear_conjugate(const TangentsOfBatch              &tangents,
                     const unsigned int                  point,
                     const GradientEntries<dim, Number> &increment,
                     const Number                       &volumetric)
    {
      return tangents.nominal_stress(point, increment) +
             (tangents.bulk_modulus * volumetric) *
               tangents.volumetric_slope(point);
    }

    template <typename Mode, typename TangentsOfBatch, typename Entries>
    ELASTO_PLASTIC_ALWAYS_INLINE static Entries
    stress_of_mode(const TangentsOfBatch &tangents,
                   const Entries         &entries,
                   const bool             has_volumetric_strain)
    {
      using Number       = typename Entries::value_type;
      const auto is_zero = [](const unsigned int entry) {
        return Mode::is_zero(entry);
      };
      const auto &slope    = tangents.volumetric_slope(0);
      Number      pressure = 0.;
      if (has_volumetric_strain)
        {
#pragma GCC unroll 9
          for (unsigned int i = 0; i < dim * dim; ++i)
            if (!is_zero(i))
              pressure += slope[i] * entries[i];
          pressure *= tangents.bulk_modulus;
        }
      Entries stress;
#pragma GCC unroll 9
      for (unsigned int i = 0; i < dim * dim; ++i)
        if (!is_zero(i))
          stress[i] = pressure * slope[i];
      tangents.nominal_tangent().stiffness.add_product(stress.data(),
                                                       entries.data(),
                                                       is_zero);
      return stress;
    }

    template <typename Evaluation, typename Number>
    ELASTO_PLASTIC_ALWAYS_INLINE static void
    submit(Evaluation                         &phi,
           const GradientEntries<dim, Number> &conjugate,
           const unsigned int                  point)
    {
      Coordinates::submit_nominal_stress(phi, conjugate, point);
    }
  };



  /// Logarithmic strains, for deformations of any size. Their volumetric part
  /// is the logarithm of the change of volume.
  template <typename Coordinates>
  struct FiniteStrain : FiniteIncrement<Coordinates>
  {
    static constexpr int dim = Coordinates::dim;

    template <typename Number>
    struct Deformation
    {
      LogarithmicStrain<dim, Number> logarithmic;
      SymmetricTensor<2, 3, Number>  strain;

      Number
      volumetric() const
      {
        return logarithmic.volumetric();
      }
    };

    template <typename Evaluation>
    static auto
    deformation_at(const Evaluation &phi, const unsigned int point)
    {
      const LogarithmicStrain<dim, NumberOf<Evaluation>> logarithmic(
        as_matrix<dim>(Coordinates::gradient_at(phi, point)));
      return Deformation<NumberOf<Evaluation>>{logarithmic,
                                               logarithmic.strain()};
    }

    template <typename Number>
    static GradientEntries<dim, Number>
    conjugate(const Deformation<Number>           &deformation,
              const SymmetricTensor<2, 3, Number> &stress)
    {
      return as_entries<dim>(deformation.logarithmic.nominal_stress(stress));
    }

    template <typename Number>
    static SymmetricTensor<2, 3, Number>
    true_stress(const Deformation<Number>           &deformation,
                const SymmetricTensor<2, 3, Number> &stress)
    {
      return deformation.logarithmic.true_stress(stress);
    }

    /// The derivative of the conjugate at a given @p stress, but for what the
    /// change of the volumetric strain contributes; and the slope of that.
    template <typename Law, typename Number>
    static void
    linearize(Tensor<2, n_gradient_entries<dim>, Number> &derivative,
              GradientEntries<dim, Number>               &volumetric_slope,
              const Deformation<Number>                  &deformation,
              const SymmetricTensor<2, 3, Number>        &stress,
              const Law                                  &deviatoric_stress,
              const Number                               &bulk_modulus)
    {
      const auto law = [&](const SymmetricTensor<2, 3, Number> &strain) {
        return SmallStrain<Coordinates>::linear_stress(deviatoric_stress,
                                                       bulk_modulus,
                                                       strain,
                                                       Number(0.));
      };
      derivative = deformation.logarithmic.nominal_tangent(stress, law);
      // (what a sheet's volume does is part of the law)
      volumetric_slope =
        Coordinates::is_sheet ?
          GradientEntries<dim, Number>() :
          as_entries<dim>(deformation.logarithmic.volumetric_slope());
    }
  };



  /// Small strains of materials whose tangent has no special form (a
  /// GeneralCriterion): tangents are nominal ones, as for finite strains.
  template <typename Coordinates>
  struct GeneralSmallStrain : FiniteIncrement<Coordinates>
  {
    static constexpr int dim = Coordinates::dim;

    template <typename Number>
    using Deformation =
      typename SmallStrain<Coordinates>::template Deformation<Number>;

    template <typename Number>
    static GradientEntries<dim, Number>
    conjugate(const Deformation<Number> &,
              const SymmetricTensor<2, 3, Number> &stress)
    {
      return as_entries<dim>(Tensor<2, 3, Number>(stress));
    }

    /// See FiniteStrain.
    template <typename Law, typename Number>
    static void
    linearize(Tensor<2, n_gradient_entries<dim>, Number> &derivative,
              GradientEntries<dim, Number>               &volumetric_slope,
              const Deformation<Number> &,
              const SymmetricTensor<2, 3, Number> &,
              const Law    &deviatoric_stress,
              const Number &bulk_modulus)
    {
      derivative = nominal_derivative<dim, Number>(
        [&](const Tensor<2, 3, Number> &gradient) {
          return Tensor<2, 3, Number>(SmallStrain<Coordinates>::linear_stress(
            deviatoric_stress, bulk_modulus, symmetrize(gradient), Number(0.)));
        });
      volumetric_slope = as_entries<dim>(
        Tensor<2, 3, Number>(unit_symmetric_tensor<3, Number>()));
    }
  };
} // namespace ElastoPlastic

#endif
