// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What preconditioners take of the tangent: its mixed form and the means of
// cells.

#include <algorithm>

#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  namespace
  {
    /// With up to this ratio, multigrid converges well.
    constexpr double moderate_bulk_to_shear = 20.;
  } // namespace



  template <int dim>
  bool
  SolidOperator<dim>::is_nearly_incompressible() const
  {
    return !is_sheet && materials.are_nearly_incompressible();
  }



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
    const types::global_dof_index n_local =
      kernel->n_batches() * kernel->n_pressures() * Number::size();
    vector.block(1).reinit(n_local,
                           types::global_dof_index(0),
                           vector.block(0).get_mpi_communicator());
    vector.collect_sizes();
  }



  template <int dim>
  void
  SolidOperator<dim>::mixed_vmult(BlockVectorType       &result,
                                  const BlockVectorType &vector) const
  {
    kernel->mixed_vmult(result, vector, tangents);
  }



  // Longitudinal waves have the modulus K + 4/3 G, and so D A^-1 D^T is about
  // the quotient of what K exceeds that of A by, and this modulus of A.
  template <int dim>
  void
  SolidOperator<dim>::precondition_pressures(VectorType &pressures) const
  {
    double *values = pressures.begin();
    for (unsigned int batch = 0; batch < kernel->n_batches(); ++batch)
      {
        const Number shear  = (4. / 3.) * shear_modulus(batch);
        const Number factor = (tangents.moderate_bulk_modulus(batch) + shear) /
                              (materials[batch].bulk_modulus + shear);
        for (unsigned int k = 0; k < kernel->n_pressures();
             ++k, values += Number::size())
          {
            Number pressure;
            pressure.load(values);
            pressure *= factor;
            pressure.store(values);
          }
      }
  }



  template <int dim>
  std::vector<Simd<double>>
  SolidOperator<dim>::mean_tangent(const unsigned int batch) const
  {
    const Number         weight = 1. / n_points;
    Tangent<dim, Number> mean;
    std::vector<Number>  values(CellTangents<dim>::n_values(is_finite),
                               Number(0.));
    for (unsigned int q = 0; q < n_points; ++q)
      if (is_finite)
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
    if (!is_finite)
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
    std::vector<double> of_cell(CellTangents<dim>::n_values(is_finite));
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



  template class SolidOperator<2>;
  template class SolidOperator<3>;
} // namespace ElastoPlastic
