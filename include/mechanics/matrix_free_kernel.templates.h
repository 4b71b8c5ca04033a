// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_matrix_free_kernel_templates_h
#define mechanics_matrix_free_kernel_templates_h

#include <array>
#include <type_traits>

#include "base/simd.h"
#include "mechanics/box_modes.h"
#include "mechanics/matrix_free_kernel.h"
#include "mechanics/strain_measures.h"

namespace ElastoPlastic
{
  template <int degree, typename StrainMeasure, typename Base>
  ELASTO_PLASTIC_ALWAYS_INLINE inline void
  MatrixFreeKernel<degree, StrainMeasure, Base>::read(
    Evaluation &phi, const unsigned int batch, const Vector &vector) const
  {
    Assert(vector.partitioners_are_compatible(
             *matrix_free.get_vector_partitioner()),
           ExcInternalError());
    phi.reinit(batch);
    nodal_access.template read<n_points>(phi.begin_dof_values(),
                                         vector.begin(),
                                         batch);
  }



  template <int degree, typename StrainMeasure, typename Base>
  ELASTO_PLASTIC_ALWAYS_INLINE inline void
  MatrixFreeKernel<degree, StrainMeasure, Base>::add(Vector     &forces,
                                                     Evaluation &phi) const
  {
    Assert(forces.partitioners_are_compatible(
             *matrix_free.get_vector_partitioner()),
           ExcInternalError());
    nodal_access.template add<n_points>(forces.begin(),
                                        phi.begin_dof_values(),
                                        phi.get_current_cell_index());
  }



  // (The eliminated entries of vector are others for this time.)
  template <int degree, typename StrainMeasure, typename Base>
  template <typename Use>
  void
  MatrixFreeKernel<degree, StrainMeasure, Base>::with_eliminated(
    const Vector &vector, const Use &use) const
  {
    Vector &complete = const_cast<Vector &>(vector);
    complete.update_ghost_values();
    eliminated.expand(complete);
    use(vector);
    eliminated.restore(complete);
    complete.zero_out_ghost_values();
  }



  template <int degree, typename StrainMeasure, typename Base>
  void
  MatrixFreeKernel<degree, StrainMeasure, Base>::collect(Vector &forces) const
  {
    eliminated.condense(forces);
    forces.compress(VectorOperation::add);
  }



  template <int degree, typename StrainMeasure, typename Base>
  template <typename MakeForces>
  void
  MatrixFreeKernel<degree, StrainMeasure, Base>::integrate_cells(
    Vector &forces, const Vector &vector, const MakeForces &make_forces) const
  {
    Evaluation phi(matrix_free);
    forces = 0.;
    with_eliminated(vector, [&](const Vector &complete) {
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        {
          read(phi, batch, complete);
          make_forces(phi);
          add(forces, phi);
        }
    });
    collect(forces);
  }



  template <int degree, typename StrainMeasure, typename Base>
  void
  MatrixFreeKernel<degree, StrainMeasure, Base>::vmult(
    Vector &forces, const Vector &increment, const Tangents &tangents) const
  {
    integrate_cells(forces, increment, [&](Evaluation &phi) {
      const unsigned int batch = phi.get_current_cell_index();
      if constexpr (keeps_cell_matrices)
        multiply(&tangents.cell_matrices[batch * n_matrix_entries],
                 phi.begin_dof_values());
      else
        {
          if constexpr (keeps_reference_tangents)
            if (!tangents.reference_tangents.empty() &&
                phi.get_cell_type() != internal::MatrixFreeFunctions::cartesian)
              {
                apply_reference_tangent(phi.begin_dof_values(),
                                        tangents.reference_tangents[batch]);
                return;
              }
          apply_tangent(phi, tangents);
        }
    });
  }



  template <int degree, typename StrainMeasure, typename Base>
  ELASTO_PLASTIC_ALWAYS_INLINE inline void
  MatrixFreeKernel<degree, StrainMeasure, Base>::average(
    AtPoints &values, const Evaluation &phi) const
  {
    if (is_b_bar())
      {
        Number integral = 0., volume = 0.;
        for (unsigned int q = 0; q < n_points; ++q)
          {
            const Number dx = StrainMeasure::volume_at(phi, q);
            integral += values[q] * dx;
            volume += dx;
          }
        values.fill(integral / volume);
      }
  }



  template <int degree, typename StrainMeasure, typename Base>
  ELASTO_PLASTIC_ALWAYS_INLINE inline void
  MatrixFreeKernel<degree, StrainMeasure, Base>::assume_tensor_products(
    const Evaluation &phi)
  {
    if (phi.get_shape_info().element_type !=
        internal::MatrixFreeFunctions::tensor_symmetric)
      __builtin_unreachable();
  }



  // (Not inlined itself, but with all that it calls: there are so many kinds of
  // kernels that the compiler would not do so, and be a tenth slower.)
  template <int degree, typename StrainMeasure, typename Base>
  [[gnu::noinline, gnu::flatten]] void
  MatrixFreeKernel<degree, StrainMeasure, Base>::apply_tangent(
    Evaluation          &phi,
    const Tangents      &tangents,
    const VolumetricLaw &volumetric_law) const
  {
    const OfBatch of_cells(tangents, phi.get_current_cell_index());
    assume_tensor_products(phi);
    phi.evaluate(StrainMeasure::flags());
    AtPoints volumetric;
    for (unsigned int q = 0; q < n_points; ++q)
      volumetric[q] =
        StrainMeasure::volumetric(of_cells,
                                  q,
                                  StrainMeasure::increment_at(phi, q));
    average(volumetric, phi);
    if (volumetric_law)
      volumetric_law(volumetric, phi);
    for (unsigned int q = 0; q < n_points; ++q)
      StrainMeasure::submit(
        phi,
        StrainMeasure::linear_conjugate(
          of_cells, q, StrainMeasure::increment_at(phi, q), volumetric[q]),
        q);
    assume_tensor_products(phi);
    phi.integrate(StrainMeasure::flags());
  }



  template <int degree, typename StrainMeasure, typename Base>
  void
  MatrixFreeKernel<degree, StrainMeasure, Base>::apply_tangent(
    Evaluation &phi, const Tangents &tangents) const
  {
    if constexpr (has_modes)
      if (phi.get_cell_type() == internal::MatrixFreeFunctions::cartesian &&
          tangents.are_constant(phi.get_current_cell_index()))
        {
          apply_tangent_by_modes(phi, tangents);
          return;
        }
    apply_tangent(phi, tangents, VolumetricLaw());
  }



  // (The mean volumetric strain is that of the constant mode.)
  template <int degree, typename StrainMeasure, typename Base>
  [[gnu::noinline, gnu::flatten]] void
  MatrixFreeKernel<degree, StrainMeasure, Base>::apply_tangent_by_modes(
    Evaluation &phi, const Tangents &tangents) const
  {
    if constexpr (has_modes)
      {
        const typename Tangents::OfConstantBatch of_cells(
          tangents, phi.get_current_cell_index());
        const auto              to_reference = phi.inverse_jacobian(0);
        std::array<Number, dim> reciprocals;
        Number                  volume = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          {
            reciprocals[d] = to_reference[d][d];
            volume /= to_reference[d][d];
          }
        apply_by_modes<StrainMeasure>(phi.begin_dof_values(),
                                      reciprocals,
                                      volume,
                                      of_cells);
      }
  }



  template <int degree, typename StrainMeasure, typename Base>
  [[gnu::noinline, gnu::flatten]] void
  MatrixFreeKernel<degree, StrainMeasure, Base>::apply_reference_tangent(
    Number *const values, const ReferenceTangent<dim, Number> &tangent) const
  {
    std::array<Number, dim> reciprocals;
    reciprocals.fill(Number(1.));
    apply_by_modes<FiniteIncrement<CartesianCoordinates<dim>>>(values,
                                                               reciprocals,
                                                               Number(1.),
                                                               tangent);
  }



  template <int degree, typename StrainMeasure, typename Base>
  template <typename Measure, typename TangentsOfBatch>
  ELASTO_PLASTIC_ALWAYS_INLINE inline void
  MatrixFreeKernel<degree, StrainMeasure, Base>::apply_by_modes(
    Number *const                  values,
    const std::array<Number, dim> &reciprocals,
    const Number                  &volume,
    const TangentsOfBatch         &tangents) const
  {
    BoxModes<dim, degree, Number>(reciprocals, volume)
      .apply(values, [&](const auto mode, const auto &gradient) {
        using Mode = std::decay_t<decltype(mode)>;
        return Measure::template stress_of_mode<Mode>(
          tangents, gradient, Mode::is_constant || !is_b_bar());
      });
  }
} // namespace ElastoPlastic

#include "mechanics/matrix_free_kernel_matrices.templates.h"

#endif
