// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/solver_control.h>

#include <algorithm>
#include <cmath>

#include "base/exceptions.h"
#include "mechanics/rigid_body_modes.h"
#include "multigrid/multigrid_preconditioner.h"
#include "solver/krylov_methods.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The coarsest mesh should not have more cells than this, which a direct
    /// solver handles in no time.
    constexpr unsigned int n_coarse_cells = 100;
    /// Beyond this number of unknowns, the coarsest level is solved
    /// iteratively.
    constexpr unsigned int largest_direct_system = 5000;
    constexpr double       coarse_reduction      = 1e-3;
    constexpr unsigned int n_coarse_iterations   = 1000;

    constexpr unsigned int n_eigenvalue_iterations = 8;

    /// An estimate of the largest eigenvalue holds for other tangents, too, as
    /// long as no entry of the diagonal's inverse has changed by more than this
    /// part: it changes by some per cent from one Newton step to the next
    /// (doc/develop, "Where the time goes"). The fifth by which deal.II
    /// raises estimates is enough for that and for their own error.
    constexpr float tolerated_change = 0.1f;



    /// The largest eigenvalue over the smallest one that the smoother damps.
    /// Where a tangent resists shears much less than changes of volume, waves
    /// as short as a few cells have small eigenvalues, too. Measured: like
    /// this, steps on adaptive meshes hardly depend on how much of the body
    /// flows, in 5 % more time than with a fixed range (doc/trust,
    /// "Iterations").
    /// (Of something that is not a number, std::min() takes the bound.)
    double
    smoothing_range(const double stiffness_ratio)
    {
      constexpr double largest_range = 100.;
      return std::min(largest_range, 8. * std::pow(stiffness_ratio, 0.375));
    }



    /// The range in the mixed form of a nearly incompressible body. (With
    /// smoothing_range(), 25 for an elastic one, more steps take the same
    /// time.)
    constexpr double smoothing_range_of_mixed_form = 60.;



    /// The degree of the Chebyshev polynomials: on the range, they are
    /// everywhere smaller than 1 / cosh(2.4), about.
    unsigned int
    smoother_degree(const double smoothing_range)
    {
      return std::lround(1.2 * std::sqrt(smoothing_range));
    }



    /// Whether the entries of @p a and @p b are the same up to that.
    /// Collective.
    bool
    are_alike(const LevelVector &a, const LevelVector &b)
    {
      bool differ = false;
      for (unsigned int i = 0; i < a.locally_owned_size(); ++i)
        differ =
          differ || !(std::abs(a.local_element(i) - b.local_element(i)) <=
                      tolerated_change * b.local_element(i));
      return !Utilities::MPI::logical_or(differ, a.get_mpi_communicator());
    }
  } // namespace



  template <int dim>
  MultigridPreconditioner<dim>::CoarseSolver::CoarseSolver(
    const LevelHierarchy<dim> &hierarchy)
    : hierarchy(hierarchy)
  {
    LevelVector layout;
    hierarchy.operators()[0]->initialize_vector(layout);
    double_solution.reinit(layout.get_partitioner());
    double_rhs.reinit(layout.get_partitioner());

    tangent.reinit(hierarchy.coarse_dof_handler(),
                   hierarchy.coarse_constraints());
    preconditioner =
      is_direct() ?
        make_factorization(layout.get_mpi_communicator()) :
        make_algebraic_multigrid(
          rigid_body_modes(hierarchy.coarse_dof_handler(), double_rhs));
  }



  template <int dim>
  bool
  MultigridPreconditioner<dim>::CoarseSolver::is_direct() const
  {
    return double_rhs.size() <= largest_direct_system ||
           !has_algebraic_multigrid;
  }



  template <int dim>
  void
  MultigridPreconditioner<dim>::CoarseSolver::prepare()
  {
    tangent.assemble(*hierarchy.operators()[0], hierarchy.held_on_coarsest());
    preconditioner->initialize(tangent.matrix(), tangent.n_patterns());
  }



  template <int dim>
  void
  MultigridPreconditioner<dim>::CoarseSolver::operator()(
    const unsigned int, LevelVector &solution, const LevelVector &rhs) const
  {
    double_rhs.copy_locally_owned_data_from(rhs);
    if (is_direct())
      preconditioner->vmult(double_solution, double_rhs);
    else if (double_rhs.linfty_norm() > 0.)
      conjugate_gradients(tangent.matrix(),
                          double_solution,
                          double_rhs,
                          *preconditioner,
                          coarse_reduction,
                          n_coarse_iterations);
    else
      double_solution = 0.;
    solution.copy_locally_owned_data_from(double_solution);
    hierarchy.operators()[0]->zero_constrained(solution);
  }



  template <int dim>
  MultigridPreconditioner<dim>::MultigridPreconditioner(
    const LoadedBody<dim>           &body,
    const SolidOperator<dim>        &solid,
    const DoFHandler<dim>           &dof_handler,
    const AffineConstraints<double> &constraints)
    : solid(solid)
    , hierarchy(body, dof_handler, constraints, n_coarse_cells)
    , coarse_solver(hierarchy)
    , level_matrices(hierarchy.operators())
    , multigrid(level_matrices,
                coarse_solver,
                hierarchy.transfer(),
                smoother,
                smoother,
                0,
                hierarchy.max_level())
    , preconditioner(dof_handler, multigrid, hierarchy.transfer())
  {}



  template <int dim>
  void
  MultigridPreconditioner<dim>::prepare(const HeldUnknowns &held)
  {
    hierarchy.update(solid, held);
    try
      {
        prepare_smoother(solid.is_nearly_incompressible() ?
                           smoothing_range_of_mixed_form :
                           smoothing_range(solid.stiffness_ratio(
                             held.constrained.get_mpi_communicator())));
      }
    catch (const SolverControl::NoConvergence &)
      {
        throw ConvergenceError(
          "The numbers of multigrid's levels are beyond "
          "single precision.");
      }
    coarse_solver.prepare();
  }



  template <int dim>
  void
  MultigridPreconditioner<dim>::prepare_smoother(const double range)
  {
    smoother.resize(0, hierarchy.max_level());
    estimates.resize(hierarchy.max_level() + 1);
    for (unsigned int level = 1; level <= hierarchy.max_level(); ++level)
      {
        const LevelOperator<dim> &matrix = *hierarchy.operators()[level];
        typename Smoother::AdditionalData settings;
        settings.smoothing_range = range;
        settings.degree          = smoother_degree(range);
        settings.preconditioner =
          std::make_shared<DiagonalMatrix<LevelVector>>();
        const LevelVector &inverse = settings.preconditioner->get_vector();
        matrix.inverse_diagonal(settings.preconditioner->get_vector());

        auto &[diagonal, largest_eigenvalue] = estimates[level];
        // (Springs raise no eigenvalue: LevelOperator::inverse_diagonal().)
        if (diagonal)
          matrix.copy_at_springs(diagonal->get_vector(), inverse);
        if (diagonal && are_alike(inverse, diagonal->get_vector()))
          {
            settings.eig_cg_n_iterations = 0;
            settings.max_eigenvalue      = largest_eigenvalue;
            smoother[level].initialize(matrix, settings);
          }
        else
          {
            settings.eig_cg_n_iterations = n_eigenvalue_iterations;
            smoother[level].initialize(matrix, settings);
            diagonal           = settings.preconditioner;
            largest_eigenvalue = smoother[level]
                                   .estimate_eigenvalues(inverse)
                                   .max_eigenvalue_estimate;
          }
      }
    // (those of the estimates, which deal.II keeps for the next ones)
    GrowingVectorMemory<LevelVector>::release_unused_memory();
  }



  // Forces may be beyond what the single precision of the levels knows.
  template <int dim>
  void
  MultigridPreconditioner<dim>::vmult(VectorType       &result,
                                      const VectorType &vector) const
  {
    const double size = vector.linfty_norm();
    result            = 0.;
    if (size == 0.)
      return;
    result.add(1. / size, vector);
    preconditioner.vmult(result, result);
    result *= size;
  }



  template class MultigridPreconditioner<2>;
  template class MultigridPreconditioner<3>;
} // namespace ElastoPlastic
