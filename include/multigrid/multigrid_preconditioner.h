// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef multigrid_multigrid_preconditioner_h
#define multigrid_multigrid_preconditioner_h

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/multigrid/mg_coarse.h>
#include <deal.II/multigrid/mg_matrix.h>
#include <deal.II/multigrid/mg_smoother.h>
#include <deal.II/multigrid/multigrid.h>

#include "multigrid/level_hierarchy.h"
#include "solver/tangent_preconditioner.h"

namespace ElastoPlastic
{
  /// A V-cycle of geometric multigrid in single precision: Chebyshev smoothing
  /// @cite adams_brezina_hu_tuminaro_2003 on all levels of a LevelHierarchy,
  /// a direct or algebraic multigrid solver on the coarsest one.
  template <int dim>
  class MultigridPreconditioner : public TangentPreconditioner
  {
  public:
    /// For the tangent that @p solid stores; the other arguments are those of
    /// LevelHierarchy.
    MultigridPreconditioner(const LoadedBody<dim>           &body,
                            const SolidOperator<dim>        &solid,
                            const DoFHandler<dim>           &dof_handler,
                            const AffineConstraints<double> &constraints);

    void
    prepare(const HeldUnknowns &held) override;

    void
    vmult(VectorType &result, const VectorType &vector) const override;

  private:
    using Smoother = PreconditionChebyshev<LevelOperator<dim>,
                                           LevelVector,
                                           DiagonalMatrix<LevelVector>>;

    /// The solver on the coarsest level, with an assembled matrix.
    class CoarseSolver : public MGCoarseGridBase<LevelVector>
    {
    public:
      CoarseSolver(const LevelHierarchy<dim> &hierarchy);

      void
      prepare();

      void
      operator()(const unsigned int level,
                 LevelVector       &solution,
                 const LevelVector &rhs) const override;

    private:
      /// Whether the preconditioner is a factorisation: the solver itself.
      bool
      is_direct() const;

      const LevelHierarchy<dim>            &hierarchy;
      TangentMatrix<dim>                    tangent;
      std::unique_ptr<MatrixPreconditioner> preconditioner;
      mutable VectorType                    double_solution, double_rhs;
    };

    /// Lets it damp the eigenvalues between the largest one and the @p range-th
    /// part of that.
    void
    prepare_smoother(const double range);

    /// What the smoother of a level takes for the largest eigenvalue, estimated
    /// when the inverse diagonal was this one.
    struct EigenvalueEstimate
    {
      std::shared_ptr<DiagonalMatrix<LevelVector>> inverse_diagonal;
      double                                       largest;
    };
    std::vector<EigenvalueEstimate> estimates;

    const SolidOperator<dim> &solid;
    LevelHierarchy<dim>       hierarchy;
    CoarseSolver              coarse_solver;

    mg::Matrix<LevelVector>                              level_matrices;
    mg::SmootherRelaxation<Smoother, LevelVector>        smoother;
    Multigrid<LevelVector>                               multigrid;
    PreconditionMG<dim, LevelVector, LevelTransfer<dim>> preconditioner;
  };
} // namespace ElastoPlastic

#endif
