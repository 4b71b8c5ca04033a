// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/matrix_free/tools.h>

#include <algorithm>
#include <sstream>

#include "base/exceptions.h"
#include "base/tensors.h"
#include "base/throw_together.h"
#include "material/plane_stress.h"
#include "mechanics/cell_operator.h"
#include "mechanics/matrix_free_solid.h"
#include "mesh/material_ids.h"

namespace ElastoPlastic
{
  namespace
  {
    unsigned int
    most_back_stresses(const std::vector<Material<double>> &materials)
    {
      unsigned int n = 0;
      for (const Material<double> &material : materials)
        n = std::max<unsigned int>(n, material.back_stresses.size());
      return n;
    }



    bool
    has_steeper_curve(const Material<double> &material)
    {
      return material.curves[0] && !material.curves[0]->is_concave();
    }
  } // namespace



  template <int dim, int degree>
  MatrixFreeSolid<dim, degree>::MatrixFreeSolid(
    const StrainModel                   &strain_model,
    const std::vector<Material<double>> &materials)
    : strain_model(strain_model)
    , materials(materials)
    , n_back_stresses(most_back_stresses(materials))
    , recovers(std::any_of(materials.begin(), materials.end(), has_recovery))
    , becomes_steeper(
        std::any_of(materials.begin(), materials.end(), has_steeper_curve))
    , n_state_values(MaterialState<Number>::n_values(n_back_stresses))
  {}



  template <int dim, int degree>
  bool
  MatrixFreeSolid<dim, degree>::has_energy() const
  {
    return !recovers;
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::reinit(
    const DoFHandler<dim>           &dof_handler,
    const AffineConstraints<double> &constraints)
  {
    reinit_matrix_free<degree>(matrix_free,
                               dof_handler,
                               constraints,
                               strain_model.kinematics);

    tangents.reinit(n_points * matrix_free.n_cell_batches());
    flow_directions.reinit(n_points * matrix_free.n_cell_batches());
    if (recovers)
      recoveries.reinit(n_points * matrix_free.n_cell_batches());
    history.clear();
    collect_materials(dof_handler.get_communicator());
  }



  // Lanes without a cell get any material.
  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::collect_materials(const MPI_Comm communicator)
  {
    std::array<const Material<double> *, Number::size()> of_lane;
    of_lane.fill(&materials.front());
    batch_materials.assign(materials.size() == 1 ? 1 :
                                                   matrix_free.n_cell_batches(),
                           join_lanes<Number>(of_lane, n_back_stresses));
    if (materials.size() == 1)
      return;
    throw_together(communicator, [&]() {
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        {
          for (unsigned int lane = 0;
               lane < matrix_free.n_active_entries_per_cell_batch(batch);
               ++lane)
            {
              const auto cell = matrix_free.get_cell_iterator(batch, lane);
              check_material_id(*cell, materials.size());
              of_lane[lane] = &materials[cell->material_id()];
            }
          batch_materials[batch] = join_lanes<Number>(of_lane, n_back_stresses);
        }
    });
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::initialize_vector(VectorType &vector) const
  {
    matrix_free.initialize_dof_vector(vector);
  }



  template <int dim, int degree>
  MaterialState<Simd<double>>
  MatrixFreeSolid<dim, degree>::old_state(const unsigned int point) const
  {
    MaterialState<Number> state(n_back_stresses);
    if (!history.empty())
      state.unpack(&history[n_state_values * point]);
    return state;
  }



  template <int dim, int degree>
  SymmetricTensor<2, 3, Simd<double>>
  MatrixFreeSolid<dim, degree>::deviator_at(
    const CellEvaluation   &phi,
    const unsigned int      point,
    const Material<Number> &material) const
  {
    Strain strain = strain_at<dim, degree>(phi, point, strain_model.kinematics);
    if (strain_model.kinematics == Kinematics::plane_stress)
      strain[2][2] =
        out_of_plane_strain(material,
                            strain,
                            old_state(n_points * phi.get_current_cell_index() +
                                      point));
    return strain_deviator(strain);
  }



  template <int dim, int degree>
  RadialReturn<Simd<double>>
  MatrixFreeSolid<dim, degree>::radial_return(
    const CellEvaluation   &phi,
    const unsigned int      point,
    const Material<Number> &material) const
  {
    return RadialReturn<Number>(
      material,
      deviator_at(phi, point, material),
      old_state(n_points * phi.get_current_cell_index() + point));
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::commit(const VectorType &u)
  {
    if (history.empty())
      history.resize(n_state_values * n_points * matrix_free.n_cell_batches(),
                     Number(0.));
    for_each_cell_batch(u, [&](CellEvaluation &phi, const unsigned int batch) {
      for (unsigned int q = 0; q < n_points; ++q)
        radial_return(phi, q, material_of(batch))
          .state()
          .pack(&history[n_state_values * (n_points * batch + q)]);
    });
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::integrate_tangent(CellEvaluation &phi) const
  {
    const unsigned int first_point = n_points * phi.get_current_cell_index();
    const Number       bulk_modulus =
      material_of(phi.get_current_cell_index()).bulk_modulus;
    integrate_linear_stress<dim, degree>(
      phi,
      bulk_modulus,
      strain_model,
      [&](const unsigned int q, const Strain &strain) {
        const auto tangent = stored_tangent(first_point + q);
        return has_energy() ? tangent * strain :
                              tangent.unsymmetric_product(strain);
      });
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::internal_forces(VectorType       &forces,
                                                const VectorType &u) const
  {
    matrix_free.template cell_loop<VectorType, VectorType>(
      [&](const auto &, auto &dst, const auto &src, const CellRange &range) {
        CellEvaluation phi(matrix_free);
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          {
            phi.reinit(batch);
            phi.read_dof_values_plain(src);
            const Material<Number> &material = material_of(batch);
            integrate_stress<dim, degree>(
              phi,
              material.bulk_modulus,
              strain_model,
              [&](const unsigned int q, const Strain &) {
                return radial_return(phi, q, material).deviatoric_stress();
              });
            phi.distribute_local_to_global(dst);
          }
      },
      forces,
      u,
      /* zero_dst_vector = */ true);
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::vmult(VectorType       &forces,
                                      const VectorType &increment) const
  {
    apply_cells<degree>(
      matrix_free,
      [this](CellEvaluation &phi) { integrate_tangent(phi); },
      forces,
      increment);
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::diagonal(VectorType &values) const
  {
    initialize_vector(values);
    MatrixFreeTools::compute_diagonal(matrix_free,
                                      values,
                                      &MatrixFreeSolid::integrate_tangent,
                                      this);
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::add_matrix(
    TrilinosWrappers::SparseMatrix  &matrix,
    const AffineConstraints<double> &all_constraints) const
  {
    add_cell_matrices<degree>(
      matrix_free,
      [this](CellEvaluation &phi) { integrate_tangent(phi); },
      all_constraints,
      matrix);
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::linearize(const VectorType &u)
  {
    for_each_cell_batch(u, [&](CellEvaluation &phi, const unsigned int batch) {
      for (unsigned int q = n_points * batch; q < n_points * (batch + 1); ++q)
        {
          const auto point =
            radial_return(phi, q % n_points, material_of(batch));
          const auto tangent = point.tangent();
          tangents.set(q,
                       {tangent.shear,
                        in_plane<dim>(tangent.normal),
                        tangent.flow_length});
          if (recovers)
            recoveries.set(q, in_plane<dim>(tangent.recovery));
          if (becomes_steeper)
            flow_directions.set(q, point.flow_direction());
        }
    });
  }



  template <int dim, int degree>
  void
  MatrixFreeSolid<dim, degree>::predict_flow(const VectorType &old_u,
                                             const VectorType &new_u)
  {
    for_each_cell_batch(
      old_u,
      new_u,
      [&](CellEvaluation    &old_phi,
          CellEvaluation    &new_phi,
          const unsigned int batch) {
        const Material<Number> &material = material_of(batch);
        for (unsigned int q = 0; q < n_points; ++q)
          {
            const unsigned int point = n_points * batch + q;
            flow_directions.set(
              point,
              radial_return(old_phi, q, material)
                .predicted_flow(flow_directions[point],
                                deviator_at(new_phi, q, material) -
                                  deviator_at(old_phi, q, material)));
          }
      });
  }



  template <int dim>
  std::unique_ptr<SolidOperator<dim>>
  make_solid_operator(const unsigned int                   degree,
                      const StrainModel                   &strain_model,
                      const std::vector<Material<double>> &materials)
  {
    if (degree == 1)
      return std::make_unique<MatrixFreeSolid<dim, 1>>(strain_model, materials);
    AssertDimension(degree, 2);
    return std::make_unique<MatrixFreeSolid<dim, 2>>(strain_model, materials);
  }



  template std::unique_ptr<SolidOperator<2>>
  make_solid_operator(const unsigned int,
                      const StrainModel &,
                      const std::vector<Material<double>> &);
  template std::unique_ptr<SolidOperator<3>>
  make_solid_operator(const unsigned int,
                      const StrainModel &,
                      const std::vector<Material<double>> &);
} // namespace ElastoPlastic
