// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef multigrid_matrix_free_level_h
#define multigrid_matrix_free_level_h

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <vector>

#include "mechanics/stress_integration.h"
#include "multigrid/level_operator.h"

namespace ElastoPlastic
{
  /// The LevelOperator on deal.II's MatrixFree, for one polynomial degree; see
  /// MatrixFreeSolid.
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
    add_matrix(TrilinosWrappers::SparseMatrix  &matrix,
               const AffineConstraints<double> &all_constraints) const override;

  private:
    using Number         = Simd<float>;
    using CellEvaluation = DisplacementEvaluation<dim, degree, float>;
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

    /// By how much the energy of a strain falls when a sheet may contract.
    Number
    relief(const Tangent &tangent,
           const Number  &trace,
           const Number  &normal_strain,
           const Number  &flow_strain) const;

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
} // namespace ElastoPlastic

#endif
