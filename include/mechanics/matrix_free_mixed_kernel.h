// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_matrix_free_mixed_kernel_h
#define mechanics_matrix_free_mixed_kernel_h

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/simd.h"
#include "mechanics/matrix_free_kernel.templates.h"
#include "mechanics/solid_kernel.h"

namespace ElastoPlastic
{
  /// What a SolidKernel does with its tangent, on deal.II's MatrixFree: the
  /// part that increments determine, whatever the deformation is.
  template <int degree, typename StrainMeasure>
  class MatrixFreeMixedKernel
    : public MatrixFreeKernel<degree,
                              StrainMeasure,
                              SolidKernel<StrainMeasure::dim>>
  {
  public:
    using Base =
      MatrixFreeKernel<degree, StrainMeasure, SolidKernel<StrainMeasure::dim>>;
    using Base::dim;
    using typename Base::CellRows;
    using typename Base::Number;
    using typename Base::Vector;

    using Base::Base;

    unsigned int
    n_pressures() const override
    {
      return this->is_b_bar() ? 1 : n_points;
    }

    void
    initialize_pressures(Vector &pressures) const override;

    void
    mixed_vmult(BlockVectorType          &result,
                const BlockVectorType    &vector,
                const PointTangents<dim> &tangents) const override;

    unsigned int
    n_cell_dofs() const override
    {
      return Base::n_dofs;
    }

    void
    volumetric_rows(CellRows                 &rows,
                    const PointTangents<dim> &tangents) const override;

    void
    multiply_rows(Vector         &pressures,
                  const CellRows &rows,
                  const Vector   &u) const override;

    void
    multiply_transposed_rows(Vector         &forces,
                             const CellRows &rows,
                             const Vector   &pressures) const override;

    void
    diagonal_of_multiples(Vector &values, const Vector &factors) const override;

  protected:
    using Base::matrix_free;
    using Base::n_points;
    using typename Base::AtPoints;
    using typename Base::Evaluation;
    using typename Base::OfBatch;

  private:
    /// In the mixed form of the tangent: makes of the @p volumetric strains of
    /// the current cells of @p phi those that belong to the bulk modulus K
    /// where the stress is that of the moderate one and the pressure. @p
    /// dilatation becomes D u - q, @p pressures is q.
    void
    mix(AtPoints                 &volumetric,
        double                   *dilatation,
        const double             *pressures,
        const Evaluation         &phi,
        const PointTangents<dim> &tangents) const;
  };



  template <int degree, typename StrainMeasure>
  void
  MatrixFreeMixedKernel<degree, StrainMeasure>::initialize_pressures(
    Vector &pressures) const
  {
    const types::global_dof_index n_local =
      matrix_free.n_cell_batches() * n_pressures() * Number::size();
    pressures.reinit(
      n_local,
      types::global_dof_index(0),
      matrix_free.get_vector_partitioner()->get_mpi_communicator());
  }



  template <int degree, typename StrainMeasure>
  void
  MatrixFreeMixedKernel<degree, StrainMeasure>::mixed_vmult(
    BlockVectorType          &result,
    const BlockVectorType    &vector,
    const PointTangents<dim> &tangents) const
  {
    const typename Base::VolumetricLaw law = [&](AtPoints         &volumetric,
                                                 const Evaluation &phi) {
      const unsigned int first =
        phi.get_current_cell_index() * n_pressures() * Number::size();
      mix(volumetric,
          result.block(1).begin() + first,
          vector.block(1).begin() + first,
          phi,
          tangents);
    };
    this->integrate_cells(result.block(0),
                          vector.block(0),
                          [&](Evaluation &phi) {
                            this->apply_tangent(phi, tangents, law);
                          });
  }



  // (Lanes without a cell have no dilatation; their volume may be zero.)
  template <int degree, typename StrainMeasure>
  ELASTO_PLASTIC_ALWAYS_INLINE inline void
  MatrixFreeMixedKernel<degree, StrainMeasure>::mix(
    AtPoints                 &volumetric,
    double                   *dilatation,
    const double             *pressures,
    const Evaluation         &phi,
    const PointTangents<dim> &tangents) const
  {
    const unsigned int batch    = phi.get_current_cell_index();
    const unsigned int n_cells  = this->n_cells(batch);
    const Number       bulk     = OfBatch(tangents, batch).bulk_modulus;
    const Number       moderate = tangents.moderate_bulk_modulus(batch);

    AtPoints volume;
    for (unsigned int q = 0; q < n_points; ++q)
      volume[q] = StrainMeasure::volume_at(phi, q);
    if (this->is_b_bar())
      volume[0] = std::accumulate(volume.begin() + 1, volume.end(), volume[0]);

    for (unsigned int k = 0; k < n_pressures(); ++k)
      {
        Number pressure;
        pressure.load(pressures + k * Number::size());
        const Number excess     = std::sqrt((bulk - moderate) * volume[k]);
        const Number difference = excess * volumetric[k] - pressure;
        for (unsigned int lane = 0; lane < Number::size(); ++lane)
          dilatation[k * Number::size() + lane] =
            lane < n_cells ? difference[lane] : 0.;
        volumetric[k] =
          (moderate * volumetric[k] + excess / volume[k] * pressure) / bulk;
      }
    if (this->is_b_bar())
      volumetric.fill(volumetric[0]);
  }



  // (the forces of the stress 1 / root of the volume)
  template <int degree, typename StrainMeasure>
  void
  MatrixFreeMixedKernel<degree, StrainMeasure>::volumetric_rows(
    CellRows &rows, const PointTangents<dim> &tangents) const
  {
    Assert(this->is_b_bar(), ExcInternalError());
    rows.reinit(matrix_free.n_cell_batches() * Base::n_dofs);
    const typename Base::VolumetricLaw law = [&](AtPoints         &volumetric,
                                                 const Evaluation &phi) {
      Number volume = 0.;
      for (unsigned int q = 0; q < n_points; ++q)
        volume += StrainMeasure::volume_at(phi, q);
      const OfBatch of_cells(tangents, phi.get_current_cell_index());
      volumetric.fill(1. / (of_cells.bulk_modulus * std::sqrt(volume)));
    };
    Evaluation phi(matrix_free);
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      {
        phi.reinit(batch);
        std::fill_n(phi.begin_dof_values(), Base::n_dofs, Number(0.));
        this->apply_tangent(phi, tangents, law);
        for (unsigned int i = 0; i < Base::n_dofs; ++i)
          {
            Number entry = phi.begin_dof_values()[i];
            for (unsigned int lane = this->n_cells(batch);
                 lane < Number::size();
                 ++lane)
              entry[lane] = 0.;
            rows.set(batch * Base::n_dofs + i, entry);
          }
      }
  }



  template <int degree, typename StrainMeasure>
  void
  MatrixFreeMixedKernel<degree, StrainMeasure>::multiply_rows(
    Vector &pressures, const CellRows &rows, const Vector &u) const
  {
    Evaluation phi(matrix_free);
    this->with_eliminated(u, [&](const Vector &complete) {
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        {
          this->read(phi, batch, complete);
          Number sum = 0.;
          for (unsigned int i = 0; i < Base::n_dofs; ++i)
            sum += rows[batch * Base::n_dofs + i] * phi.begin_dof_values()[i];
          sum.store(pressures.begin() + batch * Number::size());
        }
    });
  }



  template <int degree, typename StrainMeasure>
  void
  MatrixFreeMixedKernel<degree, StrainMeasure>::multiply_transposed_rows(
    Vector &forces, const CellRows &rows, const Vector &pressures) const
  {
    Evaluation phi(matrix_free);
    forces = 0.;
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      {
        Number pressure;
        pressure.load(pressures.begin() + batch * Number::size());
        phi.reinit(batch);
        for (unsigned int i = 0; i < Base::n_dofs; ++i)
          phi.begin_dof_values()[i] = rows[batch * Base::n_dofs + i] * pressure;
        this->add(forces, phi);
      }
    this->collect(forces);
  }



  template <int degree, typename StrainMeasure>
  void
  MatrixFreeMixedKernel<degree, StrainMeasure>::diagonal_of_multiples(
    Vector &values, const Vector &factors) const
  {
    Evaluation phi(matrix_free);
    values = 0.;
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      {
        Number factor;
        factor.load(factors.begin() + batch * Number::size());
        phi.reinit(batch);
        std::fill_n(phi.begin_dof_values(), Base::n_dofs, factor);
        this->add(values, phi);
      }
    values.compress(VectorOperation::add);
    this->hand_to_masters(values);
  }
} // namespace ElastoPlastic

#endif
