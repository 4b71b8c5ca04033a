// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_matrix_free_kernel_h
#define mechanics_matrix_free_kernel_h

#include <deal.II/matrix_free/fe_evaluation.h>

#include <array>
#include <functional>

#include "mechanics/cell_kernel.h"

namespace ElastoPlastic
{
  /// The CellKernel on deal.II's MatrixFree. New kinematics are a new
  /// @p StrainMeasure, a new material tangent a new class of @p Tangents; loops
  /// and integration stay. Residual, tangent product, matrix and diagonal use
  /// the same strains and laws, and so cannot drift apart (but for what levels
  /// of multigrid leave out in products, see ReferenceTangent). @p Base is the
  /// interface: a CellKernel or one derived from it.
  template <int degree, typename StrainMeasure, typename Base>
  class MatrixFreeKernel : public Base
  {
  public:
    static constexpr int dim = StrainMeasure::dim;
    using Tangents           = typename Base::Tangents;
    using typename Base::Number;
    using typename Base::Vector;

    using Base::Base;

    void
    vmult(Vector         &forces,
          const Vector   &increment,
          const Tangents &tangents) const override;

    void
    diagonal(Vector &values, const Tangents &tangents) const override;

    void
    add_matrix(SystemMatrix                    &matrix,
               const AffineConstraints<double> &all_constraints,
               const Tangents                  &tangents) const override;

    void
    prepare_products(Tangents &tangents) const override;

  protected:
    using Evaluation = FEEvaluation<dim,
                                    degree,
                                    degree + 1,
                                    dim,
                                    typename Tangents::value_type,
                                    Number>;
    using OfBatch    = typename Tangents::OfBatch;

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
    /// Others that are boxes, and whose tangents are constant, are treated mode
    /// by mode.
    static constexpr bool has_modes =
      StrainMeasure::has_modes && !keeps_cell_matrices &&
      (Tangents::constant_on_cells || !StrainMeasure::has_nominal_tangents);
    /// So are, in products of a level, those in space that are no boxes, as if
    /// they were parallelepipeds: it may be approximate.
    static constexpr bool keeps_reference_tangents =
      Tangents::constant_on_cells && dim == 3;
    /// Of a symmetric matrix, row by row from the diagonal on.
    static constexpr unsigned int n_matrix_entries = n_dofs * (n_dofs + 1) / 2;

    /// For each component, the stiffness at a point against the slopes of a
    /// field that has no other component: a quadratic form.
    using SlopeStiffness =
      std::array<SymmetricTensor<2, n_slopes, Number>, dim>;

    using Base::constraints;
    using Base::eliminated;
    using Base::matrix_free;
    using Base::nodal_access;
    using Base::strain_model;

    bool
    is_b_bar() const
    {
      return strain_model.treatment == VolumetricTreatment::b_bar;
    }

    /// Reads the values of a batch of cells, eliminated ones and those of
    /// other ranks included.
    void
    read(Evaluation &phi, const unsigned int batch, const Vector &vector) const;

    /// Adds the dof values of @p phi.
    void
    add(Vector &forces, Evaluation &phi) const;

    /// Calls @p use with @p vector, eliminated entries and those of other ranks
    /// included.
    template <typename Use>
    void
    with_eliminated(const Vector &vector, const Use &use) const;

    /// Hands the forces that cells have added to masters and other ranks.
    void
    collect(Vector &forces) const;

    /// Makes nodal forces of @p vector: on each batch of cells, @p make_forces
    /// does so with the dof values that it finds.
    template <typename MakeForces>
    void
    integrate_cells(Vector           &forces,
                    const Vector     &vector,
                    const MakeForces &make_forces) const;

    using AtPoints = std::array<Number, n_points>;

    /// What B-bar takes in place of the volumetric strains @p values of the
    /// current cells of @p phi: their mean.
    void
    average(AtPoints &values, const Evaluation &phi) const;

    /// Puts others in place of the volumetric strains of current cells.
    using VolumetricLaw = std::function<void(AtPoints &, const Evaluation &)>;

    /// Tells the compiler what reinit() has made sure of: which one of
    /// deal.II's ways of evaluation is taken. Where it inlines that, the
    /// others, three quarters of the code, are left out.
    static void
    assume_tensor_products(const Evaluation &phi);

    /// Makes nodal forces of the dof values of @p phi, with the
    /// @p volumetric_law if there is one. (It is called once for a batch of
    /// cells: one function for all laws, which is large, compiles faster.)
    void
    apply_tangent(Evaluation          &phi,
                  const Tangents      &tangents,
                  const VolumetricLaw &volumetric_law) const;

    void
    apply_tangent(Evaluation &phi, const Tangents &tangents) const;

    /// The same for boxes with constant tangents.
    void
    apply_tangent_by_modes(Evaluation &phi, const Tangents &tangents) const;

    /// The same for cells of other forms with their reference @p tangent.
    void
    apply_reference_tangent(Number                              *values,
                            const ReferenceTangent<dim, Number> &tangent) const;

    /// What both do: the cells are boxes with the @p reciprocals of the lengths
    /// of their edges, @p Measure knows the stresses of modes.
    template <typename Measure, typename TangentsOfBatch>
    void
    apply_by_modes(Number                        *values,
                   const std::array<Number, dim> &reciprocals,
                   const Number                  &volume,
                   const TangentsOfBatch         &tangents) const;

    /// The tangent of the current cells of @p phi, with the mean of the
    /// Jacobians.
    ReferenceTangent<dim, Number>
    reference_tangent(const Evaluation &phi, const OfBatch &tangents) const;

    void
    keep_reference_tangents(Tangents &tangents) const;

    void
    keep_cell_matrices(Tangents &tangents) const;

    /// The matrices of the current cells of @p phi, column by column.
    void
    compute_cell_matrices(AlignedVector<Number> &columns,
                          Evaluation            &phi,
                          const Tangents        &tangents) const;

    /// The product of the packed symmetric @p matrix with @p values, in place.
    static void
    multiply(const Number *matrix, Number *values);

    SlopeStiffness
    slope_stiffness(const OfBatch &tangents, const unsigned int point) const;

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
