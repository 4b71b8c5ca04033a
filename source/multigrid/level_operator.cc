// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/aligned_vector.h>
#include <deal.II/matrix_free/matrix_free.h>

#include "mechanics/cell_matrices.h"
#include "mesh/owned_cells.h"
#include "multigrid/hanging_node_patterns.h"
#include "multigrid/level_operator.h"

namespace ElastoPlastic
{
  namespace
  {
    using Number = Simd<float>;

    template <int dim, int degree>
    class MatrixFreeLevel : public LevelOperator<dim>
    {
    public:
      explicit MatrixFreeLevel(const StrainModel &strain_model)
        : strain_model(strain_model)
      {}

      void
      reinit(const DoFHandler<dim>           &dof_handler,
             const AffineConstraints<double> &new_constraints) override;

      void
      initialize_vector(LevelVector &vector) const override
      {
        matrix_free.initialize_dof_vector(vector);
      }

      void
      set_tangent_value(const unsigned int index,
                        const LevelVector &values) override;

      void
      set_held(const LevelVector &held) override;

      void
      vmult(LevelVector &result, const LevelVector &vector) const override;

      void
      inverse_diagonal(LevelVector &values) const override;

      void
      zero_held(LevelVector &vector) const override
      {
        for (const unsigned int i : held_indices)
          vector.local_element(i) = 0.f;
      }

      void
      add_matrix(
        TrilinosWrappers::SparseMatrix  &matrix,
        const AffineConstraints<double> &all_constraints) const override;

    private:
      using CellEvaluation = DisplacementEvaluation<dim, degree, float>;
      using CellRange      = std::pair<unsigned int, unsigned int>;
      using Strain         = SymmetricTensor<2, 3, Number>;

      struct Tangent
      {
        Number                         bulk_modulus;
        DeviatoricTangent<dim, Number> deviatoric;
      };

      void
      integrate_tangent(CellEvaluation &phi) const;

      /// phi_node / r at a quadrature point of a body of revolution.
      Number
      hoop_strain(const CellEvaluation &phi,
                  const unsigned int    point,
                  const unsigned int    node) const;

      /// The diagonal of the tangent of the current cells of @p phi, as its dof
      /// values.
      void
      compute_cell_diagonal(CellEvaluation &phi) const;

      const StrainModel strain_model;

      MatrixFree<dim, float, Number>   matrix_free;
      AffineConstraints<double> const *constraints = nullptr;

      /// The cell batches' tangents, and where set_tangent_value() finds the
      /// values of each lane.
      AlignedVector<Tangent>                                tangents;
      std::vector<std::array<unsigned int, Number::size()>> cells;

      /// Local indices of held unknowns, and of those and the constrained ones.
      std::vector<unsigned int>  held_indices;
      std::vector<unsigned int>  cut_off_indices;
      mutable std::vector<float> cut_off_values;
    };



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
          cells[batch][lane] =
            owned_cells.number(*matrix_free.get_cell_iterator(
              batch,
              std::min(
                lane, matrix_free.n_active_entries_per_cell_batch(batch) - 1)));
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
      integrate_stress<dim, degree>(phi,
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

      matrix_free.template cell_loop<LevelVector, LevelVector>(
        [&](const auto &, auto &dst, const auto &src, const CellRange &range) {
          CellEvaluation phi(matrix_free);
          for (unsigned int batch = range.first; batch < range.second; ++batch)
            {
              phi.reinit(batch);
              phi.read_dof_values(src);
              integrate_tangent(phi);
              phi.distribute_local_to_global(dst);
            }
        },
        result,
        vector,
        /* zero_dst_vector = */ true);

      for (unsigned int i = 0; i < cut_off_indices.size(); ++i)
        {
          source.local_element(cut_off_indices[i]) = cut_off_values[i];
          result.local_element(cut_off_indices[i]) = cut_off_values[i];
        }
    }



    template <int dim, int degree>
    Number
    MatrixFreeLevel<dim, degree>::hoop_strain(const CellEvaluation &phi,
                                              const unsigned int    point,
                                              const unsigned int    node) const
    {
      if (strain_model.kinematics == Kinematics::cartesian)
        return 0.f;
      const auto &shape = matrix_free.get_shape_info().data[0].shape_values;
      constexpr unsigned int n_1d  = degree + 1;
      Number                 value = 1.f;
      for (unsigned int e = 0, i = node, p = point; e < dim;
           ++e, i /= n_1d, p /= n_1d)
        value *= shape[(i % n_1d) * n_1d + p % n_1d];
      return value / phi.quadrature_point(point)[0];
    }



    // For the shape function phi_i e_c with the gradient g = grad phi_i, the
    // strain has the norm^2 (|g|^2 + g_c^2)/2 + h^2 and the trace g_c + h, with
    // the hoop strain h = phi_i / r for c = 0 in a body of revolution.
    template <int dim, int degree>
    void
    MatrixFreeLevel<dim, degree>::compute_cell_diagonal(
      CellEvaluation &phi) const
    {
      const auto &[bulk_modulus, tangent] =
        tangents[phi.get_current_cell_index()];
      const auto            &shape   = matrix_free.get_shape_info().data[0];
      constexpr unsigned int n_1d    = degree + 1;
      constexpr unsigned int n_nodes = Utilities::pow(n_1d, dim);

      std::array<std::array<Number, n_nodes>, dim> divergence;
      Number                                       volume = 0.f;
      std::array<std::array<Number, n_nodes>, dim> diagonal;
      for (unsigned int c = 0; c < dim; ++c)
        {
          divergence[c].fill(0.f);
          diagonal[c].fill(0.f);
        }

      for (const unsigned int q : phi.quadrature_point_indices())
        {
          const auto   inverse_jacobian = phi.inverse_jacobian(q);
          const Number dx =
            volume_of<dim, degree>(phi, q, strain_model.kinematics);
          volume += dx;
          for (unsigned int node = 0; node < n_nodes; ++node)
            {
              const Number           hoop = hoop_strain(phi, q, node);
              Tensor<1, dim, Number> unit_gradient;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  unit_gradient[d] = 1.f;
                  for (unsigned int e = 0, i = node, p = q; e < dim;
                       ++e, i /= n_1d, p /= n_1d)
                    unit_gradient[d] *=
                      (d == e ?
                         shape.shape_gradients :
                         shape.shape_values)[(i % n_1d) * n_1d + p % n_1d];
                }
              const auto g        = inverse_jacobian * unit_gradient;
              const auto normal_g = tangent.normal * g;
              const auto flow_g   = tangent.flow * g;
              const auto g_square = g * g;
              for (unsigned int c = 0; c < dim; ++c)
                {
                  const Number h     = (c == 0 ? hoop : Number(0.f));
                  const Number trace = g[c] + h;
                  Number       density =
                    tangent.shear * (0.5f * (g_square + g[c] * g[c]) + h * h -
                                     float(1. / 3.) * trace * trace) -
                    (normal_g[c] - dealii::trace(tangent.normal) * h) *
                      (flow_g[c] - dealii::trace(tangent.flow) * h);
                  if (strain_model.treatment == VolumetricTreatment::standard)
                    density += bulk_modulus * trace * trace;
                  diagonal[c][node] += density * dx;
                  divergence[c][node] += trace * dx;
                }
            }
        }

      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int node = 0; node < n_nodes; ++node)
          {
            if (strain_model.treatment == VolumetricTreatment::b_bar)
              diagonal[c][node] += bulk_modulus * divergence[c][node] *
                                   divergence[c][node] / volume;
            phi.begin_dof_values()[c * n_nodes + node] = diagonal[c][node];
          }
    }



    // Of a constrained unknown, each master gets its share of the diagonal with
    // the square of its weight; the coupling between the two is left out. (With
    // the weight itself, as in phi.distribute_local_to_global(), the weights of
    // skew rollers, which may be negative, could make the sum vanish.)
    template <int dim, int degree>
    void
    MatrixFreeLevel<dim, degree>::inverse_diagonal(LevelVector &values) const
    {
      initialize_vector(values);
      CellEvaluation            phi(matrix_free);
      std::vector<unsigned int> indices;
      for (unsigned int batch = 0; batch < matrix_free.n_cell_batches();
           ++batch)
        {
          phi.reinit(batch);
          compute_cell_diagonal(phi);
          matrix_free.get_dof_info().get_dof_indices_on_cell_batch(
            indices, batch, /* with_constraints = */ false);
          auto index = indices.begin();
          for (unsigned int lane = 0;
               lane < matrix_free.n_active_entries_per_cell_batch(batch);
               ++lane)
            for (unsigned int i = 0; i < phi.dofs_per_cell; ++i)
              values.local_element(*index++) += phi.begin_dof_values()[i][lane];
        }
      values.compress(VectorOperation::add);

      LevelVector shares;
      initialize_vector(shares);
      for (const auto &line : constraints->get_lines())
        if (values.in_local_range(line.index))
          for (const auto &[master, weight] : line.entries)
            shares(master) += weight * weight * values(line.index);
      shares.compress(VectorOperation::add);
      values += shares;

      for (const unsigned int i : cut_off_indices)
        values.local_element(i) = 1.f;
      for (unsigned int i = 0; i < values.locally_owned_size(); ++i)
        values.local_element(i) = 1.f / values.local_element(i);
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
  } // namespace



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
