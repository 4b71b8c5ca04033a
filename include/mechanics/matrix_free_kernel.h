// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_matrix_free_kernel_h
#define mechanics_matrix_free_kernel_h

#include <deal.II/matrix_free/fe_evaluation.h>

#include "mechanics/cell_kernel.h"

namespace ElastoPlastic
{
  /// The CellKernel on deal.II's MatrixFree. A new kinematics is a new
  /// @p StrainMeasure, a new material tangent a new class of @p Tangents; loops
  /// and integration stay. Residual, tangent product, matrix and diagonal use
  /// the same strains and laws, and so cannot drift apart.
  template <int dim, int degree, typename StrainMeasure, typename Tangents>
  class MatrixFreeKernel : public CellKernel<dim, Tangents>
  {
  public:
    using Base = CellKernel<dim, Tangents>;
    using typename Base::Number;
    using typename Base::Strains;
    using typename Base::Stresses;
    using typename Base::Vector;

    using Base::Base;

    void
    for_each_batch(const std::vector<const Vector *> &fields,
                   const std::function<void(const std::vector<Strains> &)>
                     &receive) const override;

    void
    integrate(Vector                                                 &forces,
              const Vector                                           &u,
              const std::function<void(const Strains &, Stresses &)> &law)
      const override;

    void
    vmult(Vector         &forces,
          const Vector   &increment,
          const Tangents &tangents) const override;

    void
    diagonal(Vector &values, const Tangents &tangents) const override;

    void
    add_matrix(TrilinosWrappers::SparseMatrix  &matrix,
               const AffineConstraints<double> &all_constraints,
               const Tangents                  &tangents) const override;

    void
    prepare_products(Tangents &tangents) const override;

  private:
    using Evaluation = FEEvaluation<dim,
                                    degree,
                                    degree + 1,
                                    dim,
                                    typename Tangents::value_type,
                                    Number>;
    using Strain     = SymmetricTensor<2, 3, Number>;
    using CellRange  = std::pair<unsigned int, unsigned int>;

    static constexpr unsigned int n_1d     = degree + 1;
    static constexpr unsigned int n_points = Utilities::pow(n_1d, dim);
    static constexpr unsigned int n_slopes = StrainMeasure::n_slopes;
    static constexpr unsigned int n_dofs   = dim * n_points;

    /// Bilinear elements are so small that a product with the matrix of the
    /// cell, of which many are needed with each tangent of a level, takes far
    /// less than strains and stresses do. (Matrices of larger elements would
    /// have to come from the memory.)
    static constexpr bool keeps_cell_matrices =
      Tangents::constant_on_cells && dim == 2 && degree == 1;
    /// Of a symmetric matrix, row by row from the diagonal on.
    static constexpr unsigned int n_matrix_entries = n_dofs * (n_dofs + 1) / 2;

    /// For each component, the stiffness at a point against the slopes of a
    /// field that has no other component: a quadratic form.
    using SlopeStiffness =
      std::array<SymmetricTensor<2, n_slopes, Number>, dim>;

    using Base::constraints;
    using Base::matrix_free;
    using Base::strain_model;

    bool
    is_b_bar() const
    {
      return strain_model.treatment == VolumetricTreatment::b_bar;
    }

    /// The volumetric strains of the current cells of @p phi, as in
    /// CellStrains.
    std::array<Number, n_points>
    volumetric_strain(const Evaluation &phi) const;

    void
    compute_strains(Strains &strains, const Evaluation &phi) const;

    /// The stress that belongs to a strain in a linear law: the strain in a
    /// sheet becomes that for which there is no stress out of plane.
    template <typename Law>
    static Strain
    linear_stress(const Law    &deviatoric_stress,
                  const Number &bulk_modulus,
                  const Strain &strain,
                  const Number &volumetric);

    /// Makes nodal forces of the dof values of @p phi.
    void
    apply_tangent(Evaluation &phi, const Tangents &tangents) const;

    /// The matrices of the current cells of @p phi, column by column.
    void
    compute_cell_matrices(AlignedVector<Number> &columns,
                          Evaluation            &phi,
                          const Tangents        &tangents) const;

    /// The product of the packed symmetric @p matrix with @p values, in place.
    static void
    multiply(const Number *matrix, Number *values);

    template <typename Law>
    SlopeStiffness
    slope_stiffness(const Law    &deviatoric_stress,
                    const Number &bulk_modulus) const;

    /// The slopes of a shape function at a quadrature point.
    Tensor<1, n_slopes, Number>
    shape_slopes(const Evaluation  &phi,
                 const unsigned int point,
                 const unsigned int node) const;

    /// The diagonal of the current cells of @p phi, as its dof values.
    void
    compute_cell_diagonal(Evaluation &phi, const Tangents &tangents) const;
  };
} // namespace ElastoPlastic

#endif
