// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What the body tells others: energy, work, tangents, states and the fields at
// points.

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
          const Number               pressure =
            mean_stress<dim>(material.bulk_modulus * volumetric[q],
                             point.deviatoric_stress(),
                             strain_model.kinematics);
          sum += (0.5 * pressure * pressure / material.bulk_modulus +
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
          {
            const Strain stress =
              radial_return(phi, q, material).deviatoric_stress();
            const Number pressure =
              mean_stress<dim>(material.bulk_modulus * volumetric[q],
                               stress,
                               strain_model.kinematics);
            const Strain virtual_strain =
              strain_at<dim, degree>(test, q, strain_model.kinematics);
            sum += (pressure * virtual_volumetric[q] +
                    stress * strain_deviator(virtual_strain)) *
                   volume_at(phi, q);
          }
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
          const Number               pressure =
            mean_stress<dim>(material.bulk_modulus * volumetric[q],
                             stress,
                             strain_model.kinematics);
          for (unsigned int d = 0; d < 3; ++d)
            stress[d][d] += pressure;
          const Number volume = volume_at(phi, q);
          const Number elastic_energy =
            point.distortion_energy() +
            0.5 * pressure * pressure / material.bulk_modulus;
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



  template <int dim, int degree>
  CellStates
  MatrixFreeSolid<dim, degree>::states() const
  {
    const unsigned int n_cell_values = n_state_values * n_points;
    CellStates         result(
      matrix_free.get_dof_handler().get_triangulation().n_active_cells());
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      for (unsigned int lane = 0;
           lane < matrix_free.n_active_entries_per_cell_batch(batch);
           ++lane)
        {
          auto &values = result[matrix_free.get_cell_iterator(batch, lane)
                                  ->active_cell_index()];
          values.assign(n_cell_values, 0.);
          if (!history.empty())
            for (unsigned int i = 0; i < n_cell_values; ++i)
              values[i] = history[n_cell_values * batch + i][lane];
        }
    return result;
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::set_states(const CellStates &states)
  {
    const unsigned int n_cell_values = n_state_values * n_points;
    history.resize(n_cell_values * matrix_free.n_cell_batches(), Number(0.));
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      for (unsigned int lane = 0;
           lane < matrix_free.n_active_entries_per_cell_batch(batch);
           ++lane)
        {
          const auto &values =
            states[matrix_free.get_cell_iterator(batch, lane)
                     ->active_cell_index()];
          for (unsigned int i = 0; i < n_cell_values; ++i)
            history[n_cell_values * batch + i][lane] = values[i];
        }
    for (unsigned int point = 0;
         point < n_points * matrix_free.n_cell_batches();
         ++point)
      {
        MaterialState<Number> state = old_state(point);
        make_admissible(state, material_of(point / n_points));
        state.pack(&history[n_state_values * point]);
      }
  }



  template class MatrixFreeSolid<2, 1>;
  template class MatrixFreeSolid<2, 2>;
  template class MatrixFreeSolid<3, 1>;
  template class MatrixFreeSolid<3, 2>;
} // namespace ElastoPlastic
