// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_matrix_free_kernel_templates_h
#define mechanics_matrix_free_kernel_templates_h

#include "mechanics/matrix_free_kernel.h"
#include "mechanics/point_response.h"
#include "mechanics/strain_measures.h"

namespace ElastoPlastic
{
  template <int dim, int degree, typename StrainMeasure, typename Tangents>
  void
  MatrixFreeKernel<dim, degree, StrainMeasure, Tangents>::for_each_batch(
    const std::vector<const Vector *>                       &fields,
    const std::function<void(const std::vector<Strains> &)> &receive) const
  {
    Evaluation           phi(matrix_free);
    std::vector<Strains> strains(fields.size());
    for (const Vector *field : fields)
      field->update_ghost_values();
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      {
        phi.reinit(batch);
        for (unsigned int f = 0; f < fields.size(); ++f)
          {
            phi.read_dof_values_plain(*fields[f]);
            phi.evaluate(StrainMeasure::flags());
            compute_strains(strains[f], phi);
          }
        receive(strains);
      }
    for (const Vector *field : fields)
      field->zero_out_ghost_values();
  }



  template <int dim, int degree, typename StrainMeasure, typename Tangents>
  void
  MatrixFreeKernel<dim, degree, StrainMeasure, Tangents>::integrate(
    Vector                                                 &forces,
    const Vector                                           &u,
    const std::function<void(const Strains &, Stresses &)> &law) const
  {
    matrix_free.template cell_loop<Vector, Vector>(
      [&](const auto &, auto &dst, const auto &src, const CellRange &range) {
        Evaluation phi(matrix_free);
        Strains    strains;
        Stresses   stresses;
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          {
            phi.reinit(batch);
            phi.read_dof_values_plain(src);
            phi.evaluate(StrainMeasure::flags());
            compute_strains(strains, phi);
            law(strains, stresses);
            for (unsigned int q = 0; q < n_points; ++q)
              StrainMeasure::submit(phi, stresses[q], q);
            phi.integrate(StrainMeasure::flags());
            phi.distribute_local_to_global(dst);
          }
      },
      forces,
      u,
      /* zero_dst_vector = */ true);
  }



  template <int dim, int degree, typename StrainMeasure, typename Tangents>
  void
  MatrixFreeKernel<dim, degree, StrainMeasure, Tangents>::vmult(
    Vector &forces, const Vector &increment, const Tangents &tangents) const
  {
    matrix_free.template cell_loop<Vector, Vector>(
      [&](const auto &, auto &dst, const auto &src, const CellRange &range) {
        Evaluation phi(matrix_free);
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          {
            phi.reinit(batch);
            phi.read_dof_values(src);
            if constexpr (keeps_cell_matrices)
              multiply(&tangents.cell_matrices[batch * n_matrix_entries],
                       phi.begin_dof_values());
            else
              apply_tangent(phi, tangents);
            phi.distribute_local_to_global(dst);
          }
      },
      forces,
      increment,
      /* zero_dst_vector = */ true);
  }



  template <int dim, int degree, typename StrainMeasure, typename Tangents>
  DEAL_II_ALWAYS_INLINE inline auto
  MatrixFreeKernel<dim, degree, StrainMeasure, Tangents>::volumetric_strain(
    const Evaluation &phi) const -> std::array<Number, n_points>
  {
    std::array<Number, n_points> values;
    for (unsigned int q = 0; q < n_points; ++q)
      values[q] = StrainMeasure::trace_at(phi, q);
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
    return values;
  }



  template <int dim, int degree, typename StrainMeasure, typename Tangents>
  void
  MatrixFreeKernel<dim, degree, StrainMeasure, Tangents>::compute_strains(
    Strains &strains, const Evaluation &phi) const
  {
    const auto volumetric = volumetric_strain(phi);
    strains.batch         = phi.get_current_cell_index();
    strains.n_points      = n_points;
    for (unsigned int q = 0; q < n_points; ++q)
      {
        strains.strain[q]     = StrainMeasure::at(phi, q);
        strains.volumetric[q] = volumetric[q];
        strains.volume[q]     = StrainMeasure::volume_at(phi, q);
      }
  }



  template <int dim, int degree, typename StrainMeasure, typename Tangents>
  template <typename Law>
  DEAL_II_ALWAYS_INLINE inline auto
  MatrixFreeKernel<dim, degree, StrainMeasure, Tangents>::linear_stress(
    const Law    &deviatoric_stress,
    const Number &bulk_modulus,
    const Strain &strain,
    const Number &volumetric) -> Strain
  {
    constexpr bool is_sheet = StrainMeasure::is_sheet;
    Strain         stress   = deviatoric_stress(strain);
    if constexpr (is_sheet)
      {
        Strain across;
        across[2][2]           = Number(1.);
        const Strain of_across = deviatoric_stress(across);
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



  // (Not inlined: in a function as large as that around it, the compiler would
  // inline nothing else.)
  template <int dim, int degree, typename StrainMeasure, typename Tangents>
  [[gnu::noinline]] void
  MatrixFreeKernel<dim, degree, StrainMeasure, Tangents>::apply_tangent(
    Evaluation &phi, const Tangents &tangents) const
  {
    const typename Tangents::OfBatch of_cells(tangents,
                                              phi.get_current_cell_index());
    phi.evaluate(StrainMeasure::flags());
    const auto volumetric = volumetric_strain(phi);
    for (unsigned int q = 0; q < n_points; ++q)
      StrainMeasure::submit(phi,
                            linear_stress(of_cells.law(q),
                                          of_cells.bulk_modulus,
                                          StrainMeasure::at(phi, q),
                                          volumetric[q]),
                            q);
    phi.integrate(StrainMeasure::flags());
  }
} // namespace ElastoPlastic

#include "mechanics/matrix_free_kernel_matrices.templates.h"

#endif
