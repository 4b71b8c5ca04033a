// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What the smoother needs of a level: the diagonal, cell by cell.

#include "multigrid/matrix_free_level.h"

namespace ElastoPlastic
{
  template <int dim, int degree>
  Simd<float>
  MatrixFreeLevel<dim, degree>::hoop_strain(const CellEvaluation &phi,
                                            const unsigned int    point,
                                            const unsigned int    node) const
  {
    if (strain_model.kinematics != Kinematics::axisymmetric)
      return 0.f;
    const auto &shape = matrix_free.get_shape_info().data[0].shape_values;
    constexpr unsigned int n_1d  = degree + 1;
    Number                 value = 1.f;
    for (unsigned int e = 0, i = node, p = point; e < dim;
         ++e, i /= n_1d, p /= n_1d)
      value *= shape[(i % n_1d) * n_1d + p % n_1d];
    return value / phi.quadrature_point(point)[0];
  }



  // By how much the energy of a strain falls when the sheet may contract:
  // the square of the out-of-plane stress over the stiffness out of plane.
  template <int dim, int degree>
  Simd<float>
  MatrixFreeLevel<dim, degree>::relief(const Tangent &tangent,
                                       const Number  &trace,
                                       const Number  &normal_strain,
                                       const Number  &flow_strain) const
  {
    const auto &[bulk_modulus, deviatoric] = tangent;
    const Number normal                    = dealii::trace(deviatoric.normal);
    const Number flow                      = dealii::trace(deviatoric.flow);
    const Number stress =
      (bulk_modulus - float(1. / 3.) * deviatoric.shear) * trace +
      0.5f * (normal * flow_strain + flow * normal_strain);
    return stress * stress /
           (bulk_modulus + float(2. / 3.) * deviatoric.shear - normal * flow);
  }



  // For the shape function phi_i e_c with the gradient g = grad phi_i, the
  // strain has the norm^2 (|g|^2 + g_c^2)/2 + h^2 and the trace g_c + h, with
  // the hoop strain h = phi_i / r for c = 0 in a body of revolution.
  template <int dim, int degree>
  void
  MatrixFreeLevel<dim, degree>::compute_cell_diagonal(CellEvaluation &phi) const
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
                    (d == e ? shape.shape_gradients :
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
                if (strain_model.kinematics == Kinematics::plane_stress)
                  density -= relief(tangents[phi.get_current_cell_index()],
                                    trace,
                                    normal_g[c],
                                    flow_g[c]);
                diagonal[c][node] += density * dx;
                divergence[c][node] += trace * dx;
              }
          }
      }

    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int node = 0; node < n_nodes; ++node)
        {
          if (strain_model.treatment == VolumetricTreatment::b_bar)
            diagonal[c][node] +=
              bulk_modulus * divergence[c][node] * divergence[c][node] / volume;
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
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
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


  template class MatrixFreeLevel<2, 1>;
  template class MatrixFreeLevel<2, 2>;
  template class MatrixFreeLevel<3, 1>;
  template class MatrixFreeLevel<3, 2>;
} // namespace ElastoPlastic
