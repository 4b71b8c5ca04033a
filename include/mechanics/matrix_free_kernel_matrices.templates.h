// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_matrix_free_kernel_matrices_templates_h
#define mechanics_matrix_free_kernel_matrices_templates_h

// The part of MatrixFreeKernel that makes matrices, diagonals and reference
// tangents; see matrix_free_kernel.templates.h.

#include <deal.II/lac/full_matrix.h>

#include <algorithm>

#include "base/simd.h"
#include "mechanics/matrix_free_kernel.h"

namespace ElastoPlastic
{
  // The columns of the cell matrices are the forces of unit vectors.
  template <int degree, typename StrainMeasure, typename Base>
  void
  MatrixFreeKernel<degree, StrainMeasure, Base>::compute_cell_matrices(
    AlignedVector<Number> &columns,
    Evaluation            &phi,
    const Tangents        &tangents) const
  {
    for (unsigned int j = 0; j < n_dofs; ++j)
      {
        std::fill_n(phi.begin_dof_values(), n_dofs, Number(0.));
        phi.begin_dof_values()[j] = Number(1.);
        apply_tangent(phi, tangents);
        std::copy_n(phi.begin_dof_values(), n_dofs, &columns[j * n_dofs]);
      }
  }



  template <int degree, typename StrainMeasure, typename Base>
  void
  MatrixFreeKernel<degree, StrainMeasure, Base>::prepare_products(
    [[maybe_unused]] Tangents &tangents) const
  {
    if constexpr (keeps_cell_matrices)
      keep_cell_matrices(tangents);
    else if constexpr (keeps_reference_tangents)
      keep_reference_tangents(tangents);
  }



  template <int degree, typename StrainMeasure, typename Base>
  void
  MatrixFreeKernel<degree, StrainMeasure, Base>::keep_cell_matrices(
    Tangents &tangents) const
  {
    Evaluation            phi(matrix_free);
    AlignedVector<Number> columns(n_dofs * n_dofs);
    tangents.cell_matrices.resize_fast(this->n_batches() * n_matrix_entries);
    Number *entry = tangents.cell_matrices.begin();
    for (unsigned int batch = 0; batch < this->n_batches(); ++batch)
      {
        phi.reinit(batch);
        compute_cell_matrices(columns, phi, tangents);
        for (unsigned int i = 0; i < n_dofs; ++i)
          for (unsigned int j = i; j < n_dofs; ++j)
            *entry++ = columns[j * n_dofs + i];
      }
  }



  template <int degree, typename StrainMeasure, typename Base>
  void
  MatrixFreeKernel<degree, StrainMeasure, Base>::keep_reference_tangents(
    Tangents &tangents) const
  {
    Evaluation phi(matrix_free);
    for (unsigned int batch = 0; batch < this->n_batches(); ++batch)
      {
        phi.reinit(batch);
        if (phi.get_cell_type() == internal::MatrixFreeFunctions::cartesian)
          continue;
        tangents.reference_tangents.resize(this->n_batches());
        tangents.reference_tangents[batch] =
          reference_tangent(phi, OfBatch(tangents, batch));
      }
  }



  // (inverse_jacobian() is transposed, its inverse too, so that these have the
  // same mean as the Jacobians.)
  template <int degree, typename StrainMeasure, typename Base>
  auto
  MatrixFreeKernel<degree, StrainMeasure, Base>::reference_tangent(
    const Evaluation &phi, const OfBatch &tangents) const
    -> ReferenceTangent<dim, Number>
  {
    NominalTangent<dim, Number> nominal;
    if constexpr (StrainMeasure::has_nominal_tangents)
      nominal = tangents.nominal_tangent();
    else
      {
        Tensor<2, n_gradient_entries<dim>, Number> derivative;
        GeneralSmallStrain<CartesianCoordinates<dim>>::linearize(
          derivative,
          nominal.volumetric_slope,
          {},
          {},
          tangents.law(0),
          tangents.bulk_modulus);
        nominal.stiffness = NominalStiffness<dim, Number>(derivative);
      }
    Tensor<2, dim, Number> x_by_xi;
    Number                 volume = 0.;
    for (unsigned int q = 0; q < n_points; ++q)
      {
        x_by_xi += Number(1. / n_points) * invert(phi.inverse_jacobian(q));
        volume += StrainMeasure::volume_at(phi, q);
      }
    return {nominal, tangents.bulk_modulus, invert(x_by_xi), volume};
  }



  template <int degree, typename StrainMeasure, typename Base>
  ELASTO_PLASTIC_ALWAYS_INLINE inline void
  MatrixFreeKernel<degree, StrainMeasure, Base>::multiply(const Number *matrix,
                                                          Number *const values)
  {
    std::array<Number, n_dofs> products;
    products.fill(Number(0.));
    // (unrolled, all values and products are in registers: 1.4 times faster)
#pragma GCC unroll 8
    for (unsigned int i = 0; i < n_dofs; ++i)
      {
        products[i] += *matrix++ * values[i];
#pragma GCC unroll 8
        for (unsigned int j = i + 1; j < n_dofs; ++j, ++matrix)
          {
            products[i] += *matrix * values[j];
            products[j] += *matrix * values[i];
          }
      }
    std::copy_n(products.begin(), n_dofs, values);
  }



  template <int degree, typename StrainMeasure, typename Base>
  void
  MatrixFreeKernel<degree, StrainMeasure, Base>::add_matrix(
    SystemMatrix                    &matrix,
    const AffineConstraints<double> &all_constraints,
    const Tangents                  &tangents) const
  {
    Evaluation                           phi(matrix_free);
    FullMatrix<double>                   cell_matrix(n_dofs, n_dofs);
    std::vector<types::global_dof_index> dofs(n_dofs);
    AlignedVector<Number>                columns(n_dofs * n_dofs);
    AssembledMatrix                     &sum = matrix;
    const auto                          &numbering =
      matrix_free.get_shape_info().lexicographic_numbering;
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      {
        phi.reinit(batch);
        compute_cell_matrices(columns, phi, tangents);
        for (unsigned int lane = 0; lane < this->n_cells(batch); ++lane)
          {
            for (unsigned int i = 0; i < n_dofs; ++i)
              for (unsigned int j = 0; j < n_dofs; ++j)
                cell_matrix(numbering[i], numbering[j]) =
                  columns[j * n_dofs + i][lane];
            this->cell(batch, lane)->get_dof_indices(dofs);
            all_constraints.distribute_local_to_global(cell_matrix, dofs, sum);
          }
      }
    matrix.compress(VectorOperation::add);
  }



  template <int degree, typename StrainMeasure, typename Base>
  auto
  MatrixFreeKernel<degree, StrainMeasure, Base>::slope_stiffness(
    const OfBatch &tangents, const unsigned int point) const -> SlopeStiffness
  {
    const auto of_unit_slope = [](const unsigned int k, const unsigned int c) {
      Tensor<1, n_slopes, Number> slopes;
      slopes[k] = Number(1.);
      return StrainMeasure::increment_of_slopes(slopes, c);
    };
    using Increment = decltype(of_unit_slope(0, 0));

    SlopeStiffness stiffness;
    for (unsigned int c = 0; c < dim; ++c)
      {
        std::array<Increment, n_slopes> increments, conjugates;
        for (unsigned int k = 0; k < n_slopes; ++k)
          {
            increments[k] = of_unit_slope(k, c);
            conjugates[k] = StrainMeasure::linear_conjugate(
              tangents,
              point,
              increments[k],
              is_b_bar() ?
                Number(0.) :
                StrainMeasure::volumetric(tangents, point, increments[k]));
          }
        for (unsigned int k = 0; k < n_slopes; ++k)
          for (unsigned int l = k; l < n_slopes; ++l)
            stiffness[c][k][l] = 0.5 * (increments[k] * conjugates[l] +
                                        increments[l] * conjugates[k]);
      }
    return stiffness;
  }



  template <int degree, typename StrainMeasure, typename Base>
  ELASTO_PLASTIC_ALWAYS_INLINE inline auto
  MatrixFreeKernel<degree, StrainMeasure, Base>::shape_slopes(
    const Evaluation  &phi,
    const unsigned int point,
    const unsigned int node) const -> Tensor<1, n_slopes, Number>
  {
    const auto            &shape = matrix_free.get_shape_info().data[0];
    Number                 value = 1.;
    Tensor<1, dim, Number> unit_gradient;
    for (unsigned int d = 0; d < dim; ++d)
      unit_gradient[d] = Number(1.);
    for (unsigned int e = 0, i = node, p = point; e < dim;
         ++e, i /= n_1d, p /= n_1d)
      {
        const unsigned int entry = (i % n_1d) * n_1d + p % n_1d;
        value *= shape.shape_values[entry];
        for (unsigned int d = 0; d < dim; ++d)
          unit_gradient[d] *=
            (d == e ? shape.shape_gradients : shape.shape_values)[entry];
      }
    return StrainMeasure::slopes_at(
      phi, point, value, phi.inverse_jacobian(point) * unit_gradient);
  }



  // The entry of a shape function is the work of the stress that belongs to its
  // strain, by the same law as everywhere, on that strain: a quadratic form in
  // its slopes. So the law is needed for unit slopes only, whatever the number
  // of shape functions.
  template <int degree, typename StrainMeasure, typename Base>
  void
  MatrixFreeKernel<degree, StrainMeasure, Base>::compute_cell_diagonal(
    Evaluation &phi, const Tangents &tangents) const
  {
    const OfBatch of_cells(tangents, phi.get_current_cell_index());

    std::array<std::array<Number, n_points>, dim> entries, divergences;
    for (unsigned int c = 0; c < dim; ++c)
      {
        entries[c].fill(Number(0.));
        divergences[c].fill(Number(0.));
      }
    Number         volume = 0.;
    SlopeStiffness stiffness;
    for (unsigned int q = 0; q < n_points; ++q)
      {
        if (q == 0 || !Tangents::constant_on_cells)
          stiffness = slope_stiffness(of_cells, q);
        const Number dx = StrainMeasure::volume_at(phi, q);
        volume += dx;
        for (unsigned int node = 0; node < n_points; ++node)
          {
            const auto slopes = shape_slopes(phi, q, node);
            SymmetricTensor<2, n_slopes, Number> squares;
            for (unsigned int k = 0; k < n_slopes; ++k)
              for (unsigned int l = k; l < n_slopes; ++l)
                squares[k][l] = dx * slopes[k] * slopes[l];
            for (unsigned int c = 0; c < dim; ++c)
              {
                entries[c][node] += stiffness[c] * squares;
                divergences[c][node] +=
                  dx *
                  StrainMeasure::volumetric(
                    of_cells, q, StrainMeasure::increment_of_slopes(slopes, c));
              }
          }
      }

    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int node = 0; node < n_points; ++node)
        phi.begin_dof_values()[c * n_points + node] =
          is_b_bar() ?
            entries[c][node] + of_cells.bulk_modulus / volume *
                                 divergences[c][node] * divergences[c][node] :
            entries[c][node];
  }



  template <int degree, typename StrainMeasure, typename Base>
  void
  MatrixFreeKernel<degree, StrainMeasure, Base>::diagonal(
    Vector &values, const Tangents &tangents) const
  {
    this->initialize_vector(values);
    Evaluation phi(matrix_free);
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      {
        phi.reinit(batch);
        compute_cell_diagonal(phi, tangents);
        add(values, phi);
      }
    values.compress(VectorOperation::add);
    this->hand_to_masters(values);
  }
} // namespace ElastoPlastic

#endif
