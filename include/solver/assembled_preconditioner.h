// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_assembled_preconditioner_h
#define solver_assembled_preconditioner_h

#include <memory>

#include "mechanics/tangent_matrix.h"
#include "solver/matrix_preconditioner.h"
#include "solver/tangent_preconditioner.h"

namespace ElastoPlastic
{
  /// Assembles the tangent for a MatrixPreconditioner.
  template <int dim>
  class AssembledPreconditioner : public TangentPreconditioner<dim>
  {
  public:
    /// @p dof_handler and @p constraints must outlive this object.
    AssembledPreconditioner(
      std::unique_ptr<MatrixPreconditioner> preconditioner,
      const DoFHandler<dim>                &dof_handler,
      const AffineConstraints<double>      &constraints)
      : preconditioner(std::move(preconditioner))
    {
      matrix.reinit(dof_handler, constraints);
    }

    void
    prepare(const SolidOperator<dim> &solid, const VectorType &held) override
    {
      matrix.assemble(solid, held);
      preconditioner->initialize(matrix.matrix());
    }

    void
    vmult(VectorType &result, const VectorType &vector) const override
    {
      preconditioner->vmult(result, vector);
    }

  private:
    const std::unique_ptr<MatrixPreconditioner> preconditioner;
    TangentMatrix<dim>                          matrix;
  };
} // namespace ElastoPlastic

#endif
