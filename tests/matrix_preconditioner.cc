// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// With all preconditioners, conjugate gradients reduce the residual of an
// elastic block as they promise, and give up as documented; a singular matrix,
// or one with numbers that are not finite, is refused; one whose pivots want
// another order than that of the analysis is factorised.

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/vector_tools.h>

#include "base/compatibility.h"
#include "material/material_parameters.h"
#include "mechanics/rigid_body_modes.h"
#include "mechanics/solid_operator.h"
#include "sample_mesh.h"
#include "solver/krylov_methods.h"
#include "solver/system_matrix.h"
#include "solver/tangent_preconditioner.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// The matrix of an elastic block of @p n_cells in each direction and a
  /// refined corner, whose bottom is held.
  class Block
  {
  public:
    static constexpr unsigned int dim = 3;

    explicit Block(const unsigned int n_cells)
      : mesh(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(1), dim)
      , dof_handler(mesh)
      , solid(std::make_unique<SolidOperator<dim>>(
          1, VolumetricTreatment::standard, MaterialParameters().materials()))
    {
      GridGenerator::subdivided_hyper_cube(mesh, n_cells, 0., 1., true);
      refine_corner(mesh);
      dof_handler.distribute_dofs(fe);
      constraints = empty_constraints(dof_handler);
      DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      constraints.close();
      solid->reinit(dof_handler, constraints);

      solid->initialize_vector(zero);
      solid->linearize(zero);
      tangent.reinit(dof_handler, constraints);
      hold({4});

      solid->initialize_vector(rhs);
      VectorTools::interpolate(dof_handler, SampleField<dim>(0, 1.), rhs);
      constraints.set_zero(rhs);
    }

    unsigned int
    n_unknowns() const
    {
      return dof_handler.n_dofs();
    }

    /// Holds other boundaries.
    void
    hold(const std::set<types::boundary_id> &boundaries)
    {
      VectorType held = zero;
      for (const auto dof : DoFTools::extract_boundary_dofs(dof_handler,
                                                            ComponentMask(),
                                                            boundaries))
        if (held.in_local_range(dof))
          held(dof) = 1.;
      tangent.assemble(*solid, {held, zero});
    }

    std::unique_ptr<MatrixPreconditioner>
    make_amg() const
    {
      return make_algebraic_multigrid(rigid_body_modes(dof_handler, rhs));
    }

    /// Solves with the reduction 1e-10. @return the one that was reached.
    double
    reached_reduction(
      const std::unique_ptr<MatrixPreconditioner> &preconditioner,
      const unsigned int                           maximum_iterations,
      unsigned int                                &n_iterations) const
    {
      VectorType solution = rhs, residual = rhs;
      preconditioner->initialize(tangent.matrix(), tangent.n_patterns());
      n_iterations = conjugate_gradients(tangent.matrix(),
                                         solution,
                                         rhs,
                                         *preconditioner,
                                         1e-10,
                                         maximum_iterations);
      tangent.matrix().vmult(residual, solution);
      residual -= rhs;
      return residual.l2_norm() / rhs.l2_norm();
    }

  private:
    parallel::distributed::Triangulation<dim> mesh;
    const FESystem<dim>                       fe;
    DoFHandler<dim>                           dof_handler;
    AffineConstraints<double>                 constraints;
    std::unique_ptr<SolidOperator<dim>>       solid;
    TangentMatrix<dim>                        tangent;
    VectorType                                zero, rhs;
  };



  /// Two matrices with the same pattern in turn.
  void
  test_factorization(Block &block)
  {
    const auto factorization = make_factorization(MPI_COMM_WORLD);
    for (const auto &boundaries :
         std::vector<std::set<types::boundary_id>>{{4}, {0, 4, 5}})
      {
        block.hold(boundaries);
        unsigned int n_iterations = 0;
        verify("  the tolerance is reached",
               block.reached_reduction(factorization, 1000, n_iterations),
               1e-10);
        verify("  in one iteration", n_iterations == 1);
      }
  }



  /// Of @p n unknowns, the unit matrix with another @p entry in one place,
  /// times a @p factor. (deal.II refuses entries that are not finite by
  /// itself.)
  bool
  is_refused(const unsigned int n, const double entry, const double factor = 1.)
  {
    const IndexSet owned =
      Utilities::MPI::create_evenly_distributed_partitioning(MPI_COMM_WORLD, n);
    SystemMatrix matrix(owned, MPI_COMM_WORLD, 1);
    for (const auto i : owned)
      matrix.set(i, i, i == n / 2 ? entry : 1.);
    matrix.compress(VectorOperation::insert);
    matrix *= factor;

    LinearAlgebra::distributed::Vector<double> rhs(owned, MPI_COMM_WORLD),
      solution(owned, MPI_COMM_WORLD);
    rhs                       = 1.;
    const auto preconditioner = make_factorization(MPI_COMM_WORLD);
    try
      {
        preconditioner->initialize(matrix, 1);
        preconditioner->vmult(solution, rhs);
        check_finite(solution.l2_norm());
      }
    catch (const ConvergenceError &)
      {
        return true;
      }
    return false;
  }



  /// On a square grid, each unknown is coupled to its neighbours, weakly, and
  /// to one that is far away; whatever the @p diagonal entries are, by the same
  /// pattern.
  class Grid
  {
  public:
    static constexpr unsigned int n = 80, n_unknowns = n * n;

    explicit Grid()
      : owned(
          Utilities::MPI::create_evenly_distributed_partitioning(MPI_COMM_WORLD,
                                                                 n_unknowns))
      , matrix(owned, MPI_COMM_WORLD, 10)
    {}

    void
    fill(const double diagonal)
    {
      for (const auto i : owned)
        {
          for (const int dy : {-1, 0, 1})
            for (const int dx : {-1, 0, 1})
              {
                const int x = i % n + dx, y = i / n + dy;
                if (x >= 0 && x < static_cast<int>(n) && y >= 0 &&
                    y < static_cast<int>(n))
                  matrix.set(i,
                             y * n + x,
                             dx == 0 && dy == 0 ? diagonal : 1e-3);
              }
          matrix.set(i, (i + n_unknowns / 2) % n_unknowns, 1.);
        }
      matrix.compress(VectorOperation::insert);
    }

    /// How far a solution is from the exact one, 1.
    double
    error(const MatrixPreconditioner &preconditioner) const
    {
      LinearAlgebra::distributed::Vector<double> one(owned, MPI_COMM_WORLD),
        rhs(owned, MPI_COMM_WORLD), solution(owned, MPI_COMM_WORLD);
      one = 1.;
      matrix.vmult(rhs, one);
      preconditioner.vmult(solution, rhs);
      solution -= one;
      return solution.linfty_norm();
    }

    const IndexSet owned;
    SystemMatrix   matrix;
  };



  /// MUMPS plans with large diagonal entries, and finds none.
  double
  error_without_diagonal()
  {
    Grid grid;
    grid.fill(100.);
    const auto factorization = make_factorization(MPI_COMM_WORLD);
    factorization->initialize(grid.matrix, 1);
    grid.fill(0.);
    factorization->initialize(grid.matrix, 1);
    return grid.error(*factorization);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // large enough for several levels of multigrid
  Block        block(9);
  unsigned int n_iterations = 0;
  verify("AMG reaches the tolerance",
         block.reached_reduction(block.make_amg(), 1000, n_iterations),
         1.01e-10);
  verify("  in 5 to 30 iterations", n_iterations >= 5 && n_iterations <= 30);
  verify("at most 5000 unknowns, for KLU", block.n_unknowns() <= 5000);
  test_factorization(block);
  Block large_block(12);
  verify("more, for MUMPS", large_block.n_unknowns() > 5000);
  test_factorization(large_block);
  verify("a small singular matrix is refused", is_refused(10, 0.));
  verify("a large singular matrix is refused", is_refused(6000, 0.));
  for (const unsigned int n : {10, 6000})
    verify("a matrix that is not finite is refused",
           is_refused(n, 1e300, 1e300));
  verify("pivots far from the diagonal are found",
         error_without_diagonal() < 1e-6);

  const double reached =
    block.reached_reduction(block.make_amg(), 3, n_iterations);
  verify("AMG with 3 iterations returns what it has found",
         reached > 1e-10 && reached < 1. && n_iterations == 3);
}
