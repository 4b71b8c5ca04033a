// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/aligned_vector.h>
#include <deal.II/matrix_free/matrix_free.h>

#include "mechanics/cell_operator.h"
#include "mesh/owned_cells.h"
#include "multigrid/hanging_node_patterns.h"
#include "multigrid/matrix_free_level.h"

namespace ElastoPlastic
{
  template <int dim, int degree>
  void
  MatrixFreeLevel<dim, degree>::reinit(
    const DoFHandler<dim>           &dof_handler,
    const AffineConstraints<double> &new_constraints)
  {
    reinit_matrix_free<degree>(matrix_free,
                               dof_handler,
                               new_constraints,
                               strain_model.kinematics,
                               hanging_node_patterns(dof_handler,
                                                     new_constraints));
    constraints = &new_constraints;
    held_indices.clear();
    cut_off_indices = matrix_free.get_constrained_dofs();

    tangents.resize(matrix_free.n_cell_batches());
    cells.resize(matrix_free.n_cell_batches());
    const OwnedCells<dim> owned_cells(dof_handler.get_triangulation());
    for (unsigned int batch = 0; batch < cells.size(); ++batch)
      for (unsigned int lane = 0; lane < Number::size(); ++lane)
        cells[batch][lane] = owned_cells.number(*matrix_free.get_cell_iterator(
          batch,
          std::min(lane,
                   matrix_free.n_active_entries_per_cell_batch(batch) - 1)));
  }



  template <int dim, int degree>
  void
  MatrixFreeLevel<dim, degree>::set_tangent_value(const unsigned int index,
                                                  const LevelVector &values)
  {
    constexpr unsigned int n_symmetric = CellTangent<dim>::n_symmetric;
    for (unsigned int batch = 0; batch < tangents.size(); ++batch)
      {
        auto &[bulk_modulus, deviatoric] = tangents[batch];
        Number &value =
          index == 0 ?
            bulk_modulus :
          index == 1 ?
            deviatoric.shear :
          index < 2 + n_symmetric ?
            deviatoric.normal.access_raw_entry(index - 2) :
            deviatoric.flow.access_raw_entry(index - 2 - n_symmetric);
        for (unsigned int lane = 0; lane < Number::size(); ++lane)
          value[lane] = values.local_element(cells[batch][lane]);
      }
  }



  template <int dim, int degree>
  void
  MatrixFreeLevel<dim, degree>::set_held(const LevelVector &held)
  {
    held_indices.clear();
    for (unsigned int i = 0; i < held.locally_owned_size(); ++i)
      if (held.local_element(i) > 0.5f)
        held_indices.push_back(i);
    cut_off_indices = matrix_free.get_constrained_dofs();
    cut_off_indices.insert(cut_off_indices.end(),
                           held_indices.begin(),
                           held_indices.end());
  }



  template <int dim, int degree>
  void
  MatrixFreeLevel<dim, degree>::integrate_tangent(CellEvaluation &phi) const
  {
    const Tangent &tangent = tangents[phi.get_current_cell_index()];
    integrate_linear_stress<dim, degree>(phi,
                                         tangent.bulk_modulus,
                                         strain_model,
                                         [&](const unsigned int,
                                             const Strain &strain) {
                                           return tangent.deviatoric * strain;
                                         });
  }



  // The entries of vector at the unknowns that are cut off are zero for the
  // time of the loop: the operator is symmetric.
  template <int dim, int degree>
  void
  MatrixFreeLevel<dim, degree>::vmult(LevelVector       &result,
                                      const LevelVector &vector) const
  {
    auto &source = const_cast<LevelVector &>(vector);
    cut_off_values.resize(cut_off_indices.size());
    for (unsigned int i = 0; i < cut_off_indices.size(); ++i)
      std::swap(cut_off_values[i] = 0.f,
                source.local_element(cut_off_indices[i]));

    apply_cells<degree>(
      matrix_free,
      [this](CellEvaluation &phi) { integrate_tangent(phi); },
      result,
      vector);

    for (unsigned int i = 0; i < cut_off_indices.size(); ++i)
      {
        source.local_element(cut_off_indices[i]) = cut_off_values[i];
        result.local_element(cut_off_indices[i]) = cut_off_values[i];
      }
  }



  template <int dim, int degree>
  void
  MatrixFreeLevel<dim, degree>::add_matrix(
    TrilinosWrappers::SparseMatrix  &matrix,
    const AffineConstraints<double> &all_constraints) const
  {
    add_cell_matrices<degree>(
      matrix_free,
      [this](CellEvaluation &phi) { integrate_tangent(phi); },
      all_constraints,
      matrix);
  }



  template <int dim>
  std::unique_ptr<LevelOperator<dim>>
  make_level_operator(const unsigned int degree,
                      const StrainModel &strain_model)
  {
    if (degree == 1)
      return std::make_unique<MatrixFreeLevel<dim, 1>>(strain_model);
    AssertDimension(degree, 2);
    return std::make_unique<MatrixFreeLevel<dim, 2>>(strain_model);
  }



  template std::unique_ptr<LevelOperator<2>>
  make_level_operator(const unsigned int, const StrainModel &);
  template std::unique_ptr<LevelOperator<3>>
  make_level_operator(const unsigned int, const StrainModel &);
} // namespace ElastoPlastic
