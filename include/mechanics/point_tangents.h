// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_point_tangents_h
#define mechanics_point_tangents_h

#include <deal.II/base/aligned_vector.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/kinematics.h"
#include "base/packed_lanes.h"
#include "base/simd.h"
#include "base/single_precision_storage.h"
#include "base/tensors.h"
#include "mechanics/packed_deviator.h"
#include "mechanics/tangents.h"

namespace ElastoPlastic
{
  /// The tangents of the problem: at all quadrature points of all cell batches,
  /// rounded to single precision, directions more than that. A batch in which
  /// nothing flows has one shear modulus. The flow directions are those of the
  /// prediction (doc/theory, "Newton's method for plasticity"). If the
  /// strains are finite, or the criteria general, the products take what
  /// SolidKernel::linearize() makes of all tangents, the nominal ones.
  template <int dim>
  class PointTangents
  {
  public:
    using value_type = double;
    using Number     = Simd<double>;
    using Tensor3    = SymmetricTensor<2, 3, Number>;

    /// Of elements of degree 2.
    static constexpr unsigned int max_points = Utilities::pow(3, dim);

    static constexpr bool constant_on_cells = false;

    /// What a point of a batch in which something flows takes of the memory,
    /// in one lane.
    static constexpr unsigned int bytes_of_flowing_point =
      (2 * sizeof(PackedLanes<float>) + 2 * sizeof(PackedDeviator<dim>)) /
      Number::size();

    /// @p recovers tells whether back stresses recover, and so make the
    /// tangents unsymmetric.
    PointTangents(const unsigned int n_points_per_cell,
                  const bool         recovers,
                  const StrainModel &strain_model)
      : n_points(n_points_per_cell)
      , recovers(recovers)
      , are_nominal(strain_model.has_nominal_tangents())
      , are_general(strain_model.has_general_criteria)
      , flow_share(recovers ? 0. : 0.5)
    {}

    /// All tangents and flow directions are zero.
    void
    reinit(const unsigned int n_cell_batches)
    {
      for (AlignedVector<Number> *moduli : {&bulk_moduli, &shear_moduli})
        {
          moduli->resize_fast(n_cell_batches);
          moduli->fill(Number(0.));
        }
      tangents        = Batches<PointTangent>(n_cell_batches);
      flow_directions = Batches<PackedDeviator<dim>>(n_cell_batches);
      recoveries = Batches<PackedDeviator<dim>>(recovers ? n_cell_batches : 0);
      if (are_nominal)
        {
          nominal_stiffnesses.resize(0);
          nominal_stiffnesses.resize(n_points * n_cell_batches);
          volumetric_slopes.reinit(n_points * n_cell_batches);
        }
      if (are_nominal && recovers)
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
      moderate_bulk_moduli.resize(bulk_moduli.size());
      moderate_bulk_moduli[batch] = value;
    }

    const Number &
    moderate_bulk_modulus(const unsigned int batch) const
    {
      return moderate_bulk_moduli[batch];
    }

    /// The tangents at the points of a batch of cells.
    void
    set(const unsigned int                                 batch,
        const std::array<OpenTangent<Number>, max_points> &of_points)
    {
      shear_moduli[batch] = of_points[0].shear;
      if (are_elastic(of_points))
        {
          release(tangents[batch]);
          if (recovers)
            release(recoveries[batch]);
          return;
        }
      tangents[batch].resize(n_points);
      for (unsigned int q = 0; q < n_points; ++q)
        tangents[batch][q] = {of_points[q].shear,
                              of_points[q].flow_length,
                              PackedDeviator<dim>(of_points[q].normal)};
      if (!recovers)
        return;
      recoveries[batch].resize(n_points);
      for (unsigned int q = 0; q < n_points; ++q)
        recoveries[batch][q] = PackedDeviator<dim>(of_points[q].recovery);
    }

    using GeneralTangent = SymmetricTensor<4, 3, Number>;

    /// The deviatoric tangents at the points of a batch of cells, with general
    /// criteria: those of which nominal tangents are made next.
    void
    set_general(const std::array<GeneralTangent, max_points> &of_points)
    {
      general_tangents = of_points;
    }

    /// The law of the deviatoric stress at a point of the batch of cells for
    /// which set() has just been called.
    auto
    law(const unsigned int batch, const unsigned int point) const
    {
      return [this, point, of_flow = OfBatch(*this, batch).law(point)](
               const Tensor3 &strain) -> Tensor3 {
        if (are_general)
          return general_tangents[point] * strain;
        return of_flow(strain);
      };
    }

    /// The derivative of the nominal stress is @p matrix, without the part of
    /// the volumetric strain, which has the @p volumetric_slope.
    void
    set_nominal(const unsigned int                                batch,
                const unsigned int                                point,
                const Tensor<2, n_gradient_entries<dim>, Number> &matrix,
                const GradientEntries<dim, Number> &volumetric_slope)
    {
      const unsigned int i   = n_points * batch + point;
      nominal_stiffnesses[i] = PackedStiffness(matrix);
      volumetric_slopes.set(i, volumetric_slope);
      if (recovers)
        skew_parts.set(i, SkewPart<dim, Number>(matrix));
    }

    NominalTangent<dim, Number>
    nominal(const unsigned int batch, const unsigned int point) const
    {
      const unsigned int          i = n_points * batch + point;
      NominalTangent<dim, Number> tangent;
      const auto                 &entries = nominal_stiffnesses[i].entries;
      std::copy(entries.begin(),
                entries.end(),
                tangent.stiffness.entries.begin());
      tangent.volumetric_slope = volumetric_slopes[i];
      return tangent;
    }

    Tensor3
    flow_direction(const unsigned int batch, const unsigned int point) const
    {
      return flow_directions[batch].empty() ?
               Tensor3() :
               flow_directions[batch][point].unpack();
    }

    /// Those at the points of a batch of cells.
    void
    set_flow_directions(const unsigned int                     batch,
                        const std::array<Tensor3, max_points> &of_points)
    {
      flow_directions[batch].resize(n_points);
      for (unsigned int q = 0; q < n_points; ++q)
        flow_directions[batch][q] = PackedDeviator<dim>(of_points[q]);
    }

    /// They are zero from now on, and take no memory.
    void
    forget_flow_directions(const unsigned int batch)
    {
      release(flow_directions[batch]);
    }

    /// A positive definite approximation: without recovery, and where the flow
    /// direction is stiff, without it. (If that can be, the flow direction must
    /// be that of the normal.)
    DeviatoricTangent<dim, Number>
    definite(const unsigned int batch, const unsigned int point) const
    {
      auto tangent = without_recovery(batch, point);
      if (!are_constant(batch))
        {
          const Number is_soft =
            compare_and_apply_mask<SIMDComparison::less_than>(
              Number(tangents[batch][point].flow_length),
              Number(0.),
              Number(0.),
              Number(1.));
          tangent.normal *= is_soft;
          tangent.flow *= is_soft;
        }
      return tangent;
    }

    /// Whether the tangents of a batch of cells are the same at all points of a
    /// cell, because there is no flow.
    bool
    are_constant(const unsigned int batch) const
    {
      return tangents[batch].empty();
    }

    /// The tangents of such a batch.
    class OfConstantBatch
    {
    public:
      OfConstantBatch(const PointTangents &all, const unsigned int batch)
        : bulk_modulus(all.bulk_moduli[batch])
        , shear(all.shear_moduli[batch])
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
        , batch(batch)
      {}

      ELASTO_PLASTIC_ALWAYS_INLINE inline TangentLaw<
        dim,
        Number,
        DeviatoricTangent<dim, Number>>
      law(const unsigned int point) const
      {
        return {all.complete(batch, point), all.flow_share};
      }

      /// See NominalTangent.
      GradientEntries<dim, Number>
      nominal_stress(const unsigned int                  point,
                     const GradientEntries<dim, Number> &increment) const
      {
        const unsigned int i      = all.n_points * batch + point;
        auto               stress = all.nominal_stiffnesses[i] * increment;
        if (all.recovers)
          stress += all.skew_parts[i] * increment;
        return stress;
      }

      GradientEntries<dim, Number>
      volumetric_slope(const unsigned int point) const
      {
        return all.volumetric_slopes[all.n_points * batch + point];
      }

      const Number bulk_modulus;

    private:
      const PointTangents &all;
      const unsigned int   batch;
    };

  private:
    using InPlane         = SymmetricTensor<2, dim, Number>;
    using PackedStiffness = NominalStiffness<dim, PackedLanes<float>>;

    /// What describes the tangent at a point, but for the flow direction: its
    /// flow is flow_length times that.
    struct PointTangent
    {
      PackedLanes<float>  shear, flow_length;
      PackedDeviator<dim> normal;
    };

    /// For each batch of cells, nothing or something for each of its points.
    template <typename T>
    using Batches = std::vector<std::vector<T>>;

    template <typename T>
    static void
    release(std::vector<T> &of_batch)
    {
      std::vector<T>().swap(of_batch);
    }

    /// Whether there is no flow, and one shear modulus. (Where there is flow,
    /// the normal does not vanish: flow_length may.)
    bool
    are_elastic(
      const std::array<OpenTangent<Number>, max_points> &of_points) const
    {
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const Number normal = of_points[q].normal.norm();
          for (unsigned int lane = 0; lane < Number::size(); ++lane)
            if (normal[lane] != 0. ||
                of_points[q].shear[lane] != of_points[0].shear[lane])
              return false;
        }
      return true;
    }

    ELASTO_PLASTIC_ALWAYS_INLINE inline DeviatoricTangent<dim, Number>
    without_recovery(const unsigned int batch, const unsigned int point) const
    {
      if (are_constant(batch))
        return {shear_moduli[batch], InPlane(), InPlane()};
      const PointTangent            &stored = tangents[batch][point];
      DeviatoricTangent<dim, Number> tangent{
        stored.shear, in_plane<dim>(stored.normal.unpack()), InPlane()};
      if (!flow_directions[batch].empty())
        tangent.flow = Number(stored.flow_length) *
                       in_plane<dim>(flow_directions[batch][point].unpack());
      return tangent;
    }

    ELASTO_PLASTIC_ALWAYS_INLINE inline DeviatoricTangent<dim, Number>
    complete(const unsigned int batch, const unsigned int point) const
    {
      auto tangent = without_recovery(batch, point);
      if (recovers && !are_constant(batch))
        tangent.flow += in_plane<dim>(recoveries[batch][point].unpack());
      return tangent;
    }

    const unsigned int n_points;
    const bool         recovers;
    const bool         are_nominal;
    const bool         are_general;
    /// See DeviatoricTangent::product().
    const Number flow_share;

    /// The shear moduli are those of first points.
    AlignedVector<Number> bulk_moduli, moderate_bulk_moduli, shear_moduli;

    Batches<PointTangent>        tangents;
    Batches<PackedDeviator<dim>> flow_directions;
    /// What recovering back stresses add to the flow of the tangents.
    Batches<PackedDeviator<dim>> recoveries;
    /// Of the batch under way.
    std::array<GeneralTangent, max_points> general_tangents;
    /// Those of are_nominal only.
    AlignedVector<PackedStiffness>                       nominal_stiffnesses;
    SinglePrecisionStorage<GradientEntries<dim, Number>> volumetric_slopes;
    SinglePrecisionStorage<SkewPart<dim, Number>>        skew_parts;
  };
} // namespace ElastoPlastic

#endif
