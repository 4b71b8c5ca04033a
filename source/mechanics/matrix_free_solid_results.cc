// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What the body tells others: energy, work, tangents and the fields at points.

#include "base/tensors.h"
#include "mechanics/matrix_free_solid.h"

namespace ElastoPlastic
{
  template <int dim, int degree>
  double
  MatrixFreeSolid<dim, degree>::energy(const VectorType &u) const
  {
    double local_energy = 0;
    for_each_cell_batch(u, [&](CellEvaluation &phi, const unsigned int batch) {
      const Material<Number> &material = material_of(batch);
      const auto volumetric = volumetric_strain<dim, degree>(phi, strain_model);
      Number     sum        = 0.;
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const RadialReturn<Number> point = radial_return(phi, q, material);
          sum += (0.5 * material.bulk_modulus * volumetric[q] * volumetric[q] +
                  (has_energy() ?
                     point.energy() :
                     point.distortion_energy() + point.plastic_work())) *
                 volume_at(phi, q);
        }
      for (unsigned int lane = 0;
           lane < matrix_free.n_active_entries_per_cell_batch(batch);
           ++lane)
        local_energy += sum[lane];
    });
    return Utilities::MPI::sum(local_energy, u.get_mpi_communicator());
  }



  template <int dim, int degree>
  double
  MatrixFreeSolid<dim, degree>::virtual_work(const VectorType &u,
                                             const VectorType &w) const
  {
    double local_work = 0;
    for_each_cell_batch(
      u,
      w,
      [&](CellEvaluation &phi, CellEvaluation &test, const unsigned int batch) {
        const Material<Number> &material = material_of(batch);
        const auto              volumetric =
          volumetric_strain<dim, degree>(phi, strain_model);
        const auto virtual_volumetric =
          volumetric_strain<dim, degree>(test, strain_model);
        Number sum = 0.;
        for (unsigned int q = 0; q < n_points; ++q)
          sum +=
            (material.bulk_modulus * volumetric[q] * virtual_volumetric[q] +
             radial_return(phi, q, material).deviatoric_stress() *
               deviator_at(test, q)) *
            volume_at(phi, q);
        for (unsigned int lane = 0;
             lane < matrix_free.n_active_entries_per_cell_batch(batch);
             ++lane)
          local_work += sum[lane];
      });
    return Utilities::MPI::sum(local_work, u.get_mpi_communicator());
  }



  // Where the flow direction is stiff, the tangent without it is definite.
  template <int dim, int degree>
  DeviatoricTangent<dim, Simd<double>>
  MatrixFreeSolid<dim, degree>::definite_tangent(const unsigned int point) const
  {
    auto tangent = symmetric_tangent(point);
    if (becomes_steeper)
      {
        const Number is_soft =
          compare_and_apply_mask<SIMDComparison::greater_than>(
            tangents[point].flow_length, Number(0.), Number(1.), Number(0.));
        tangent.normal *= is_soft;
        tangent.flow *= is_soft;
      }
    return tangent;
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::for_each_cell_tangent(
    const std::function<
      void(const typename DoFHandler<dim>::active_cell_iterator &cell,
           const CellTangent<dim> &tangent)> &receive) const
  {
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      for (unsigned int lane = 0;
           lane < matrix_free.n_active_entries_per_cell_batch(batch);
           ++lane)
        {
          CellTangent<dim> mean = {material_of(batch).bulk_modulus[lane], {}};
          auto            &sum  = mean.deviatoric;
          for (unsigned int q = 0; q < n_points; ++q)
            {
              const auto   tangent = definite_tangent(n_points * batch + q);
              const double weight  = 1. / n_points;
              sum.shear += weight * tangent.shear[lane];
              for (unsigned int i = 0; i < CellTangent<dim>::n_symmetric; ++i)
                {
                  sum.normal.access_raw_entry(i) +=
                    weight * tangent.normal.access_raw_entry(i)[lane];
                  sum.flow.access_raw_entry(i) +=
                    weight * tangent.flow.access_raw_entry(i)[lane];
                }
            }
          receive(matrix_free.get_cell_iterator(batch, lane), mean);
        }
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::for_each_cell(
    const VectorType &u,
    const std::function<
      void(const typename DoFHandler<dim>::active_cell_iterator &cell,
           const std::vector<PointResult> &points)> &receive) const
  {
    // for each lane, the points of its cell
    std::array<std::vector<PointResult>, Number::size()> results;
    results.fill(std::vector<PointResult>(n_points));
    for_each_cell_batch(u, [&](CellEvaluation &phi, const unsigned int batch) {
      const Material<Number> &material = material_of(batch);
      const auto volumetric = volumetric_strain<dim, degree>(phi, strain_model);
      const unsigned int n_cells =
        matrix_free.n_active_entries_per_cell_batch(batch);
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const RadialReturn<Number> point  = radial_return(phi, q, material);
          const auto                 state  = point.state();
          auto                       stress = point.deviatoric_stress();
          for (unsigned int d = 0; d < 3; ++d)
            stress[d][d] += material.bulk_modulus * volumetric[q];
          const Number volume = volume_at(phi, q);
          const Number elastic_energy =
            point.distortion_energy() +
            0.5 * material.bulk_modulus * volumetric[q] * volumetric[q];
          const Number hardening_energy = point.hardening_energy();
          const Number plastic_work     = point.plastic_work();
          const Number dissipation      = point.dissipation();

          for (unsigned int lane = 0; lane < n_cells; ++lane)
            {
              PointResult &result = results[lane][q];
              for (unsigned int i = 0; i < 6; ++i)
                {
                  result.stress.access_raw_entry(i) =
                    stress.access_raw_entry(i)[lane];
                  result.plastic_strain.access_raw_entry(i) =
                    state.plastic_strain.access_raw_entry(i)[lane];
                }
              result.equivalent_plastic_strain =
                state.equivalent_plastic_strain[lane];
              result.plastic        = state.equivalent_plastic_strain[lane] > 0;
              result.volume         = volume[lane];
              result.elastic_energy = elastic_energy[lane];
              result.hardening_energy = hardening_energy[lane];
              result.plastic_work     = plastic_work[lane];
              result.dissipation      = dissipation[lane];
            }
        }
      for (unsigned int lane = 0; lane < n_cells; ++lane)
        receive(matrix_free.get_cell_iterator(batch, lane), results[lane]);
    });
  }



  template class MatrixFreeSolid<2, 1>;
  template class MatrixFreeSolid<2, 2>;
  template class MatrixFreeSolid<3, 1>;
  template class MatrixFreeSolid<3, 2>;
} // namespace ElastoPlastic
