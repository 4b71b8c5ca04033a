// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_tangent_preconditioner_h
#define solver_tangent_preconditioner_h

#include <deal.II/dofs/dof_handler.h>

#include <memory>

#include "solver/matrix_preconditioner.h"
#include "solver/tangent_operator.h"

namespace ElastoPlastic
{
  /// A symmetric, positive definite approximation of the inverse of a tangent,
  /// some unknowns being constrained.
  class TangentPreconditioner
  {
  public:
    virtual ~TangentPreconditioner() = default;

    /// Takes the tangent that is stored now. @p constrained has ones at the
    /// constrained unknowns that this rank owns, zeros elsewhere.
    virtual void
    prepare(const VectorType &constrained) = 0;

    /// Both vectors are zero at constrained and eliminated unknowns.
    virtual void
    vmult(VectorType &result, const VectorType &vector) const = 0;
  };



  /// An assembled tangent, with hanging nodes condensed and constrained
  /// unknowns eliminated (their rows and columns are diagonal).
  template <int dim>
  class TangentMatrix
  {
  public:
    /// Sets up the sparsity pattern; both arguments must outlive this object
    /// or the next call.
    void
    reinit(const DoFHandler<dim>           &dof_handler,
           const AffineConstraints<double> &constraints);

    /// Assembles the tangent that @p tangent has stored: a TangentOperator or
    /// what else has add_matrix(). @p constrained is as in
    /// TangentPreconditioner.
    template <typename Operator>
    void
    assemble(const Operator &tangent, const VectorType &constrained)
    {
      system_matrix = 0;
      tangent.add_matrix(system_matrix, with_constrained(constrained));
    }

    const TrilinosWrappers::SparseMatrix &
    matrix() const;

  private:
    /// The constraints and, as homogeneous ones, the constrained unknowns.
    AffineConstraints<double>
    with_constrained(const VectorType &constrained) const;

    const DoFHandler<dim>           *dof_handler = nullptr;
    const AffineConstraints<double> *constraints = nullptr;
    IndexSet                         relevant_dofs;
    TrilinosWrappers::SparseMatrix   system_matrix;
  };



  /// Assembles the tangent for a MatrixPreconditioner.
  template <int dim>
  class AssembledPreconditioner : public TangentPreconditioner
  {
  public:
    /// The references must outlive this object.
    AssembledPreconditioner(
      const TangentOperator                &tangent,
      std::unique_ptr<MatrixPreconditioner> preconditioner,
      const DoFHandler<dim>                &dof_handler,
      const AffineConstraints<double>      &constraints)
      : tangent(tangent)
      , preconditioner(std::move(preconditioner))
    {
      matrix.reinit(dof_handler, constraints);
    }

    void
    prepare(const VectorType &constrained) override
    {
      matrix.assemble(tangent, constrained);
      preconditioner->initialize(matrix.matrix());
    }

    void
    vmult(VectorType &result, const VectorType &vector) const override
    {
      preconditioner->vmult(result, vector);
    }

  private:
    const TangentOperator                      &tangent;
    const std::unique_ptr<MatrixPreconditioner> preconditioner;
    TangentMatrix<dim>                          matrix;
  };
} // namespace ElastoPlastic

#endif
