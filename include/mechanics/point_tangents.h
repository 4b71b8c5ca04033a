// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_point_tangents_h
#define mechanics_point_tangents_h

#include <deal.II/base/aligned_vector.h>

#include <vector>

#include "base/inlining.h"
#include "base/single_precision_storage.h"
#include "base/tensors.h"
#include "mechanics/tangents.h"

namespace ElastoPlastic
{
  /// The tangents of the problem: at all quadrature points of all cell batches,
  /// rounded to single precision. The flow directions are those of the
  /// prediction (doc/theory.md, "Newton's method for plasticity"). If the
  /// strains are finite, the products take what SolidKernel::linearize() makes
  /// of them, the nominal tangents.
  template <int dim>
  class PointTangents
  {
  public:
    using value_type = double;
    using Number     = Simd<double>;
    using Tensor3    = SymmetricTensor<2, 3, Number>;

    static constexpr bool constant_on_cells = false;

    /// @p recovers tells whether back stresses recover, and so make the
    /// tangents unsymmetric.
    PointTangents(const unsigned int n_points_per_cell,
                  const bool         recovers,
                  const bool         strains_are_finite)
      : n_points(n_points_per_cell)
      , recovers(recovers)
      , strains_are_finite(strains_are_finite)
      , flow_share(recovers ? 0. : 0.5)
    {}

    /// All tangents and flow directions are zero.
    void
    reinit(const unsigned int n_cell_batches)
    {
      for (AlignedVector<Number> *moduli :
           {&bulk_moduli, &moderate_bulk_moduli})
        {
          moduli->resize_fast(n_cell_batches);
          moduli->fill(Number(0.));
        }
      elastic.assign(n_cell_batches, 0);
      tangents.reinit(n_points * n_cell_batches);
      flow_directions.reinit(n_points * n_cell_batches);
      if (recovers)
        recoveries.reinit(n_points * n_cell_batches);
      if (strains_are_finite)
        nominal_tangents.reinit(n_points * n_cell_batches);
      if (strains_are_finite && recovers)
        skew_parts.reinit(n_points * n_cell_batches);
    }

    void
    set_bulk_modulus(const unsigned int batch, const Number &value)
    {
      bulk_moduli[batch] = value;
    }

    /// The smaller one that takes its place in the mixed form, see
    /// TangentOperator.
    void
    set_moderate_bulk_modulus(const unsigned int batch, const Number &value)
    {
      moderate_bulk_moduli[batch] = value;
    }

    const Number &
    moderate_bulk_modulus(const unsigned int batch) const
    {
      return moderate_bulk_moduli[batch];
    }

    void
    set(const unsigned int         batch,
        const unsigned int         point,
        const OpenTangent<Number> &tangent)
    {
      const unsigned int i = n_points * batch + point;
      tangents.set(
        i, {tangent.shear, in_plane<dim>(tangent.normal), tangent.flow_length});
      elastic[batch] = (point == 0 || elastic[batch]) && !recovers &&
                       is_elastic_as(i, n_points * batch);
      if (recovers)
        recoveries.set(i, in_plane<dim>(tangent.recovery));
    }

    /// The derivative of the nominal stress is @p matrix, without the part of
    /// the volumetric strain, which has the @p volumetric_slope.
    void
    set_nominal(const unsigned int                                batch,
                const unsigned int                                point,
                const Tensor<2, n_gradient_entries<dim>, Number> &matrix,
                const GradientEntries<dim, Number> &volumetric_slope)
    {
      const unsigned int i = n_points * batch + point;
      nominal_tangents.set(i, {symmetrize(matrix), volumetric_slope});
      if (recovers)
        skew_parts.set(i, SkewPart<dim, Number>(matrix));
    }

    NominalTangent<dim, Number>
    nominal(const unsigned int batch, const unsigned int point) const
    {
      return nominal_tangents[n_points * batch + point];
    }

    Tensor3
    flow_direction(const unsigned int batch, const unsigned int point) const
    {
      return flow_directions[n_points * batch + point];
    }

    void
    set_flow_direction(const unsigned int batch,
                       const unsigned int point,
                       const Tensor3     &direction)
    {
      flow_directions.set(n_points * batch + point, direction);
    }

    /// A positive definite approximation: without recovery, and where the flow
    /// direction is stiff, without it. (If that can be, the flow direction must
    /// be that of the normal.)
    DeviatoricTangent<dim, Number>
    definite(const unsigned int batch, const unsigned int point) const
    {
      auto         tangent = without_recovery(n_points * batch + point);
      const Number is_soft = compare_and_apply_mask<SIMDComparison::less_than>(
        tangents[n_points * batch + point].flow_length,
        Number(0.),
        Number(0.),
        Number(1.));
      tangent.normal *= is_soft;
      tangent.flow *= is_soft;
      return tangent;
    }

    /// Whether the tangents of a batch of cells are the same at all points of a
    /// cell, because there is no flow. (Where back stresses recover, always
    /// no.)
    bool
    are_constant(const unsigned int batch) const
    {
      return elastic[batch];
    }

    /// The tangents of such a batch.
    class OfConstantBatch
    {
    public:
      OfConstantBatch(const PointTangents &all, const unsigned int batch)
        : bulk_modulus(all.bulk_moduli[batch])
        , shear(PointTangent(all.tangents[all.n_points * batch]).shear)
      {}

      ELASTO_PLASTIC_ALWAYS_INLINE inline auto
      law(const unsigned int) const
      {
        return [this](const Tensor3 &strain) {
          return shear * strain_deviator(strain);
        };
      }

      const Number bulk_modulus;

    private:
      const Number shear;
    };

    /// The tangents of a batch of cells.
    class OfBatch
    {
    public:
      OfBatch(const PointTangents &all, const unsigned int batch)
        : bulk_modulus(all.bulk_moduli[batch])
        , all(all)
        , first_point(all.n_points * batch)
      {}

      ELASTO_PLASTIC_ALWAYS_INLINE inline TangentLaw<
        dim,
        Number,
        DeviatoricTangent<dim, Number>>
      law(const unsigned int point) const
      {
        return {all.complete(first_point + point), all.flow_share};
      }

      /// See NominalTangent.
      GradientEntries<dim, Number>
      nominal_stress(const unsigned int                  point,
                     const GradientEntries<dim, Number> &increment) const
      {
        const unsigned int i = first_point + point;
        auto stress = all.nominal_tangents[i].stiffness_times(increment);
        if (all.recovers)
          stress += all.skew_parts[i] * increment;
        return stress;
      }

      GradientEntries<dim, Number>
      volumetric_slope(const unsigned int point) const
      {
        return all.nominal_tangents[first_point + point].volumetric_slope;
      }

      const Number bulk_modulus;

    private:
      const PointTangents &all;
      const unsigned int   first_point;
    };

  private:
    /// What describes the tangent at a point, but for the flow direction: its
    /// flow is flow_length times that.
    struct PointTangent
    {
      Number                          shear;
      SymmetricTensor<2, dim, Number> normal;
      Number                          flow_length;
    };

    /// Whether there is no flow at point @p i, and its shear modulus that of
    /// @p other.
    bool
    is_elastic_as(const unsigned int i, const unsigned int other) const
    {
      const PointTangent a = tangents[i], b = tangents[other];
      bool               result = true;
      for (unsigned int lane = 0; lane < Number::size(); ++lane)
        result =
          result && a.flow_length[lane] == 0. && a.shear[lane] == b.shear[lane];
      return result;
    }

    ELASTO_PLASTIC_ALWAYS_INLINE inline DeviatoricTangent<dim, Number>
    without_recovery(const unsigned int i) const
    {
      const PointTangent tangent = tangents[i];
      return {tangent.shear,
              tangent.normal,
              tangent.flow_length * in_plane<dim>(flow_directions[i])};
    }

    ELASTO_PLASTIC_ALWAYS_INLINE inline DeviatoricTangent<dim, Number>
    complete(const unsigned int i) const
    {
      auto tangent = without_recovery(i);
      if (recovers)
        tangent.flow += recoveries[i];
      return tangent;
    }

    const unsigned int n_points;
    const bool         recovers;
    const bool         strains_are_finite;
    /// See DeviatoricTangent::product().
    const Number flow_share;

    AlignedVector<Number> bulk_moduli, moderate_bulk_moduli;
    std::vector<char>     elastic;

    /// Of all points. What recovering back stresses add to the flow of the
    /// tangents takes no memory if none does.
    SinglePrecisionStorage<PointTangent>                    tangents;
    SinglePrecisionStorage<Tensor3>                         flow_directions;
    SinglePrecisionStorage<SymmetricTensor<2, dim, Number>> recoveries;
    /// Of finite strains only.
    SinglePrecisionStorage<NominalTangent<dim, Number>> nominal_tangents;
    SinglePrecisionStorage<SkewPart<dim, Number>>       skew_parts;
  };
} // namespace ElastoPlastic

#endif
