// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_matrix_free_solid_h
#define mechanics_matrix_free_solid_h

#include <deal.II/base/aligned_vector.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <vector>

#include "base/single_precision_storage.h"
#include "base/tensors.h"
#include "mechanics/stress_integration.h"

namespace ElastoPlastic
{
  /// The SolidOperator on deal.II's MatrixFree, for one polynomial degree.
  ///
  /// There is one cell kernel, integrate_stress() (stress_integration.h): it
  /// evaluates the strain, asks a "point law" for the deviatoric stress, adds
  /// the pressure and integrates against the strains of the shape functions.
  /// The residual passes the radial return as the law, the tangent product the
  /// stored tangent; diagonal and matrix are tangent products with unit
  /// vectors. So residual and tangent cannot drift apart.
  template <int dim, int degree>
  class MatrixFreeSolid : public SolidOperator<dim>
  {
  public:
    MatrixFreeSolid(const StrainModel                   &strain_model,
                    const std::vector<Material<double>> &materials);

    bool
    has_energy() const override;

    void
    reinit(const DoFHandler<dim>           &dof_handler,
           const AffineConstraints<double> &constraints) override;

    void
    commit(const VectorType &u) override;

    CellStates
    states() const override;

    void
    set_states(const CellStates &states) override;

    void
    initialize_vector(VectorType &vector) const override;

    double
    energy(const VectorType &u) const override;

    void
    internal_forces(VectorType &forces, const VectorType &u) const override;

    double
    virtual_work(const VectorType &u, const VectorType &w) const override;

    void
    linearize(const VectorType &u) override;

    void
    predict_flow(const VectorType &old_u, const VectorType &new_u) override;

    void
    vmult(VectorType &forces, const VectorType &increment) const override;

    void
    diagonal(VectorType &values) const override;

    void
    add_matrix(TrilinosWrappers::SparseMatrix  &matrix,
               const AffineConstraints<double> &all_constraints) const override;

    void
    for_each_cell_tangent(
      const std::function<
        void(const typename DoFHandler<dim>::active_cell_iterator &cell,
             const CellTangent<dim> &tangent)> &receive) const override;

    void
    for_each_cell(
      const VectorType &u,
      const std::function<
        void(const typename DoFHandler<dim>::active_cell_iterator &cell,
             const std::vector<PointResult> &points)> &receive) const override;

  private:
    using Number         = Simd<double>;
    using Strain         = SymmetricTensor<2, 3, Number>;
    using CellEvaluation = DisplacementEvaluation<dim, degree, double>;
    using CellRange      = std::pair<unsigned int, unsigned int>;

    static constexpr unsigned int n_points = Utilities::pow(degree + 1, dim);

    /// Finds the materials of all cell batches.
    void
    collect_materials(const MPI_Comm communicator);

    /// The materials of the cells of a batch.
    const Material<Number> &
    material_of(const unsigned int cell_batch) const
    {
      return batch_materials[materials.size() == 1 ? 0 : cell_batch];
    }

    /// The state before the step at a point, counted over all batches.
    MaterialState<Number>
    old_state(const unsigned int point) const;

    /// The radial return at a point of the current cell, from the state before
    /// the step.
    RadialReturn<Number>
    radial_return(const CellEvaluation   &phi,
                  const unsigned int      point,
                  const Material<Number> &material) const;

    /// The deviator of the strain at a point of the current cell.
    Strain
    deviator_at(const CellEvaluation   &phi,
                const unsigned int      point,
                const Material<Number> &material) const;

    /// The volume of a point of the current cell.
    Number
    volume_at(const CellEvaluation &phi, const unsigned int point) const
    {
      return volume_of<dim, degree>(phi, point, strain_model.kinematics);
    }

    /// The tangent at a point, as linearize() has left it.
    DeviatoricTangent<dim, Number>
    stored_tangent(const unsigned int point) const
    {
      auto tangent = symmetric_tangent(point);
      if (recovers)
        tangent.flow += recoveries[point];
      return tangent;
    }

    /// The same without recovery of back stresses.
    DeviatoricTangent<dim, Number>
    symmetric_tangent(const unsigned int point) const
    {
      const PointTangent tangent = tangents[point];
      return {tangent.shear,
              tangent.normal,
              tangent.flow_length * in_plane<dim>(flow_directions[point])};
    }

    /// A positive definite approximation of it.
    DeviatoricTangent<dim, Number>
    definite_tangent(const unsigned int point) const;

    /// The kernel with the stored tangent as point law.
    void
    integrate_tangent(CellEvaluation &phi) const;

    /// Loops over all cells with the displacement @p u evaluated, for
    /// everything that only reads: body(phi, cell_batch).
    template <typename Body>
    void
    for_each_cell_batch(const VectorType &u, const Body &body) const;

    /// The same for two displacement fields: body(phi, w_phi, cell_batch).
    template <typename Body>
    void
    for_each_cell_batch(const VectorType &u,
                        const VectorType &w,
                        const Body       &body) const;

    const StrainModel                   strain_model;
    const std::vector<Material<double>> materials;
    /// The largest number of back stresses that a material has.
    const unsigned int n_back_stresses;
    /// Whether a back stress recovers.
    const bool recovers;
    /// Whether a hardening curve becomes steeper. Then a point can be stiff in
    /// the flow direction, and only the exact one makes the tangent positive
    /// definite: it is not predicted.
    const bool becomes_steeper;

    MatrixFree<dim, double, Number> matrix_free;

    /// One for each cell batch, or only one if there is only one material.
    std::vector<Material<Number>> batch_materials;

    /// What describes the tangent at a point, but for the flow direction: its
    /// flow is flow_length times that.
    struct PointTangent
    {
      Number                          shear;
      SymmetricTensor<2, dim, Number> normal;
      Number                          flow_length;
    };

    /// Of all points, n_points per cell batch: the tangents and the predicted
    /// flow directions; with recovering back stresses, what these add to the
    /// flow of the tangents.
    SinglePrecisionStorage<PointTangent>                    tangents;
    SinglePrecisionStorage<SymmetricTensor<2, 3, Number>>   flow_directions;
    SinglePrecisionStorage<SymmetricTensor<2, dim, Number>> recoveries;

    /// The states of all points before the step, packed, n_state_values
    /// numbers each; none as long as all points are virgin.
    AlignedVector<Number> history;
    const unsigned int    n_state_values;
  };



  template <int dim, int degree>
  template <typename Body>
  void
  MatrixFreeSolid<dim, degree>::for_each_cell_batch(const VectorType &u,
                                                    const Body &body) const
  {
    CellEvaluation phi(matrix_free);
    u.update_ghost_values();
    for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
      {
        phi.reinit(batch);
        phi.read_dof_values_plain(u);
        phi.evaluate(strain_flags(strain_model.kinematics));
        body(phi, batch);
      }
    u.zero_out_ghost_values();
  }



  template <int dim, int degree>
  template <typename Body>
  void
  MatrixFreeSolid<dim, degree>::for_each_cell_batch(const VectorType &u,
                                                    const VectorType &w,
                                                    const Body &body) const
  {
    CellEvaluation w_phi(matrix_free);
    w.update_ghost_values();
    for_each_cell_batch(u, [&](CellEvaluation &phi, const unsigned int batch) {
      w_phi.reinit(batch);
      w_phi.read_dof_values_plain(w);
      w_phi.evaluate(strain_flags(strain_model.kinematics));
      body(phi, w_phi, batch);
    });
    w.zero_out_ghost_values();
  }
} // namespace ElastoPlastic

#endif
