// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What preconditioners take of the tangent: its mixed form and the means of
// cells.

#include <algorithm>
#include <cmath>

#include "mechanics/pressure_model.h"
#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  namespace
  {
    /// With up to this ratio, multigrid converges well.
    constexpr double moderate_bulk_to_shear = 20.;

    /// Of the shear modulus across the flow, what stiffness_ratio() takes to be
    /// left along it, at least: no smoother can follow perfect plasticity.
    constexpr double least_share_along_flow = 0.02;
  } // namespace



  template <int dim>
  Simd<double>
  SolidOperator<dim>::shear_modulus(const unsigned int batch) const
  {
    if (!is_b_bar)
      return materials[batch].shear_modulus;
    Number sum = 0.;
    for (unsigned int q = 0; q < n_points; ++q)
      sum += 0.5 * tangents.definite(batch, q).shear;
    return sum * (1. / n_points);
  }



  template <int dim>
  void
  SolidOperator<dim>::moderate_bulk_moduli()
  {
    for (unsigned int batch = 0; batch < kernel->n_batches(); ++batch)
      tangents.set_moderate_bulk_modulus(batch,
                                         std::min(materials[batch].bulk_modulus,
                                                  moderate_bulk_to_shear *
                                                    shear_modulus(batch)));
  }



  template <int dim>
  void
  SolidOperator<dim>::initialize_mixed_vector(BlockVectorType &vector) const
  {
    vector.reinit(2);
    initialize_vector(vector.block(0));
    kernel->initialize_pressures(vector.block(1));
    vector.collect_sizes();
  }



  template <int dim>
  std::unique_ptr<const PressurePreconditioner>
  SolidOperator<dim>::make_pressure_preconditioner(const VectorType &held) const
  {
    std::vector<typename PressureModel<dim>::Moduli> moduli(
      kernel->n_batches());
    for (unsigned int batch = 0; batch < moduli.size(); ++batch)
      moduli[batch] = {materials[batch].bulk_modulus,
                       tangents.moderate_bulk_modulus(batch),
                       shear_modulus(batch)};
    return std::make_unique<PressureModel<dim>>(*kernel,
                                                tangents,
                                                moduli,
                                                held);
  }



  template <int dim>
  std::vector<Simd<double>>
  SolidOperator<dim>::mean_tangent(const unsigned int batch) const
  {
    const Number         weight = 1. / n_points;
    Tangent<dim, Number> mean;
    std::vector<Number>  values(
      CellTangents<dim>::n_values(has_nominal_tangents), Number(0.));
    for (unsigned int q = 0; q < n_points; ++q)
      if (has_nominal_tangents)
        {
          const auto tangent = tangents.nominal(batch, q);
          for (unsigned int i = 1; i < values.size(); ++i)
            values[i] += weight * tangent.value(i - 1);
        }
      else
        {
          const auto tangent = tangents.definite(batch, q);
          mean.deviatoric.shear += weight * tangent.shear;
          mean.deviatoric.normal += weight * tangent.normal;
          mean.deviatoric.flow += weight * tangent.flow;
        }
    if (!has_nominal_tangents)
      for (unsigned int i = 1; i < values.size(); ++i)
        values[i] = mean.value(i);
    values[0] = is_nearly_incompressible() ?
                  tangents.moderate_bulk_modulus(batch) :
                  materials[batch].bulk_modulus;
    return values;
  }



  template <int dim>
  void
  SolidOperator<dim>::for_each_cell_tangent(
    const std::function<
      void(const typename DoFHandler<dim>::active_cell_iterator &cell,
           const std::vector<double> &values)> &receive) const
  {
    std::vector<double> of_cell(
      CellTangents<dim>::n_values(has_nominal_tangents));
    for (unsigned int batch = 0; batch < kernel->n_batches(); ++batch)
      {
        const auto values = mean_tangent(batch);
        for (unsigned int lane = 0; lane < kernel->n_cells(batch); ++lane)
          {
            for (unsigned int i = 0; i < of_cell.size(); ++i)
              of_cell[i] = values[i][lane];
            receive(kernel->cell(batch, lane), of_cell);
          }
      }
  }



  template <int dim>
  Simd<double>
  SolidOperator<dim>::stiffness_ratio(const unsigned int batch) const
  {
    const Number weight = 0.5 / n_points;
    Number       shear = 0., smallest_shear = 0.;
    for (unsigned int q = 0; q < n_points; ++q)
      {
        const auto tangent = tangents.definite(batch, q);
        shear += weight * tangent.shear;
        smallest_shear += weight * tangent.smallest_eigenvalue();
      }
    const Number bulk = materials[batch].bulk_modulus;
    const Number p_wave =
      is_sheet ? 4. * shear * (3. * bulk + shear) / (3. * bulk + 4. * shear) :
                 bulk + 4. / 3. * shear;
    return p_wave / std::max(smallest_shear, least_share_along_flow * shear);
  }



  template <int dim>
  double
  SolidOperator<dim>::stiffness_ratio(const MPI_Comm communicator) const
  {
    double sum_and_cells[2] = {0., 0.};
    auto &[sum, n_cells]    = sum_and_cells;
    for (unsigned int batch = 0; batch < kernel->n_batches(); ++batch)
      {
        const Number ratio = stiffness_ratio(batch);
        for (unsigned int lane = 0; lane < kernel->n_cells(batch); ++lane)
          sum += std::log(ratio[lane]);
        n_cells += kernel->n_cells(batch);
      }
    Utilities::MPI::sum(sum_and_cells, communicator, sum_and_cells);
    return std::exp(sum / n_cells);
  }
} // namespace ElastoPlastic
