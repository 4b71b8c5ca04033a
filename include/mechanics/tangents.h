// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_tangents_h
#define mechanics_tangents_h

#include <deal.II/base/aligned_vector.h>

#include "base/simd.h"
#include "material/deviatoric_tangent.h"
#include "mechanics/nominal_tangent.h"
#include "mechanics/reference_tangent.h"

namespace ElastoPlastic
{
  /// A tangent: the stress increment K tr(strain) 1 + deviatoric * strain.
  template <int dim, typename Number>
  struct Tangent
  {
    static constexpr unsigned int n_symmetric = dim * (dim + 1) / 2;
    static constexpr unsigned int n_values    = 2 + 2 * n_symmetric;

    Number                         bulk_modulus = Number(0.);
    DeviatoricTangent<dim, Number> deviatoric;

    /// One of the n_values numbers that it consists of.
    Number &
    value(const unsigned int i)
    {
      return i == 0 ? bulk_modulus :
             i == 1 ? deviatoric.shear :
             i < 2 + n_symmetric ?
                      deviatoric.normal.access_raw_entry(i - 2) :
                      deviatoric.flow.access_raw_entry(i - 2 - n_symmetric);
    }

    const Number &
    value(const unsigned int i) const
    {
      return const_cast<Tangent &>(*this).value(i);
    }
  };



  /// What makes deviatoric stresses of strains, see
  /// DeviatoricTangent::product(). @p StoredTangent is a DeviatoricTangent, or
  /// a reference to one that is stored elsewhere.
  template <int dim, typename Number, typename StoredTangent>
  struct TangentLaw
  {
    StoredTangent tangent;
    Number        flow_share;

    ELASTO_PLASTIC_ALWAYS_INLINE inline SymmetricTensor<2, 3, Number>
    operator()(const SymmetricTensor<2, 3, Number> &strain) const
    {
      return tangent.product(strain, flow_share);
    }
  };



  /// The tangents of a level of multigrid: in single precision, one for each
  /// cell, symmetric; nominal ones if StrainModel::has_nominal_tangents().
  template <int dim>
  class CellTangents
  {
  public:
    using value_type = float;
    using Number     = Simd<float>;

    static constexpr bool constant_on_cells = true;

    explicit CellTangents(const bool are_nominal)
      : are_nominal(are_nominal)
    {}

    void
    reinit(const unsigned int n_cell_batches)
    {
      tangents.resize(n_cell_batches);
      if (are_nominal)
        nominal_tangents.resize(n_cell_batches);
    }

    /// The number of numbers that describe a cell's tangent: those of a
    /// Tangent; or, if they are nominal, the bulk modulus and those of a
    /// NominalTangent.
    static constexpr unsigned int
    n_values(const bool are_nominal)
    {
      return are_nominal ? 1 + NominalTangent<dim, Number>::n_values :
                           Tangent<dim, Number>::n_values;
    }

    /// One of these numbers.
    Number &
    value(const unsigned int batch, const unsigned int i)
    {
      return are_nominal && i > 0 ? nominal_tangents[batch].value(i - 1) :
                                    tangents[batch].value(i);
    }

    /// The tangent of a batch of cells.
    class OfBatch
    {
    public:
      OfBatch(const CellTangents &all, const unsigned int batch)
        : bulk_modulus(all.tangents[batch].bulk_modulus)
        , tangent(all.tangents[batch].deviatoric)
        , nominal(all.nominal_tangents.data() + batch)
      {}

      ELASTO_PLASTIC_ALWAYS_INLINE inline TangentLaw<
        dim,
        Number,
        const DeviatoricTangent<dim, Number> &>
      law(const unsigned int) const
      {
        return {tangent, Number(0.5)};
      }

      /// See NominalTangent.
      GradientEntries<dim, Number>
      nominal_stress(const unsigned int,
                     const GradientEntries<dim, Number> &increment) const
      {
        return nominal->stiffness * increment;
      }

      const NominalTangent<dim, Number> &
      nominal_tangent() const
      {
        return *nominal;
      }

      const GradientEntries<dim, Number> &
      volumetric_slope(const unsigned int) const
      {
        return nominal->volumetric_slope;
      }

      const Number bulk_modulus;

    private:
      const DeviatoricTangent<dim, Number> &tangent;
      const NominalTangent<dim, Number>    *nominal;
    };

    static bool
    are_constant(const unsigned int)
    {
      return true;
    }

    using OfConstantBatch = OfBatch;

    /// What CellKernel::prepare_products() has computed of the tangents, if it
    /// has.
    AlignedVector<Number>                        cell_matrices;
    AlignedVector<ReferenceTangent<dim, Number>> reference_tangents;

  private:
    const bool                                 are_nominal;
    AlignedVector<Tangent<dim, Number>>        tangents;
    AlignedVector<NominalTangent<dim, Number>> nominal_tangents;
  };
} // namespace ElastoPlastic

#endif
