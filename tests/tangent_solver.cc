// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The solver for tangents: a method that fails, because its result is not
// finite or its iterations are used up, is replaced by the next for good, with
// one warning; what has been prepared serves for similar tangents, as long as
// it does and the same unknowns are held; and coupled unknowns move together,
// at little more than the cost of held ones once the body's response is known;
// all this also with an unsymmetric tangent.

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
#include "solver/tangent_solver.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  constexpr unsigned int dim = 2;

  /// Multiplies by a number, or fails if that is 0, and says when it is
  /// prepared, which fails if the number is negative.
  class Scaling : public TangentPreconditioner
  {
  public:
    Scaling(const std::string &name, const double factor)
      : name(name)
      , factor(factor)
    {}

    void
    prepare(const HeldUnknowns &held) override
    {
      output() << "  " << name << " is prepared, " << held.constrained.l1_norm()
               << " held" << std::endl;
      if (factor < 0.)
        throw_singular();
    }

    void
    vmult(VectorType &result, const VectorType &vector) const override
    {
      if (factor == 0.)
        throw_singular();
      result.equ(factor, vector);
    }

  private:
    const std::string name;
    const double      factor;
  };



  /// A tangent times -1, as if the body were unstable.
  class Opposite : public TangentOperator
  {
  public:
    explicit Opposite(const TangentOperator &tangent)
      : tangent(tangent)
    {}

    bool
    is_symmetric() const override
    {
      return false;
    }

    void
    initialize_vector(VectorType &vector) const override
    {
      tangent.initialize_vector(vector);
    }

    void
    vmult(VectorType &forces, const VectorType &increment) const override
    {
      tangent.vmult(forces, increment);
      forces *= -1.;
    }

    bool
    is_nearly_incompressible() const override
    {
      return false;
    }

    void
    initialize_mixed_vector(BlockVectorType &vector) const override
    {
      tangent.initialize_mixed_vector(vector);
    }

    void
    mixed_vmult(BlockVectorType       &forces,
                const BlockVectorType &increment) const override
    {
      tangent.mixed_vmult(forces, increment);
      forces *= -1.;
    }

    std::unique_ptr<const PressurePreconditioner>
    make_pressure_preconditioner(const VectorType &held) const override
    {
      return tangent.make_pressure_preconditioner(held);
    }

    void
    add_matrix(SystemMatrix                    &matrix,
               const AffineConstraints<double> &all_constraints) const override
    {
      SystemMatrix stable;
      stable.reinit(matrix);
      tangent.add_matrix(stable, all_constraints);
      matrix.add(-1., stable);
    }

  private:
    const TangentOperator &tangent;
  };



  MaterialParameters
  recovering_material()
  {
    MaterialParameters parameters;
    parameters.laws               = {MaterialLaw::nonlinear_hardening};
    parameters.back_stress_moduli = {"60000 | 10000"};
    parameters.recovery_rates     = {"600 | 50"};
    return parameters;
  }



  /// A block whose bottom is held. It is elastic until it is made to flow().
  class Block
  {
  public:
    using Method = TangentSolver::Method;

    explicit Block(const MaterialParameters &material)
      : mesh(MPI_COMM_WORLD)
      , fe(FE_Q<dim>(1), dim)
      , dof_handler(mesh)
      , solid(std::make_unique<SolidOperator<dim>>(
          1, VolumetricTreatment::standard, material.materials()))
    {
      GridGenerator::subdivided_hyper_cube(mesh, 6, 0., 1., true);
      dof_handler.distribute_dofs(fe);
      constraints = empty_constraints(dof_handler);
      constraints.close();
      solid->reinit(dof_handler, constraints);
      solid->initialize_vector(rhs);
      solid->linearize(rhs);
      held = boundary_entries(2, ComponentMask());
      top  = boundary_entries(3, ComponentMask(std::vector<bool>{false, true}));
      VectorTools::interpolate(dof_handler, SampleField<dim>(0, 1.), rhs);
    }

    /// Plastic flow, first in one direction, then in another.
    void
    flow()
    {
      VectorType u = rhs;
      u *= 0.02;
      solid->commit(u);
      VectorTools::interpolate(dof_handler, SampleField<dim>(1, 0.02), u);
      solid->linearize(u);
    }

    void
    check_fallback(const std::string &title, const std::vector<Method> &methods)
    {
      output() << title << std::endl;
      TangentSolver solver(*solid, methods, [](const std::string &warning) {
        output() << "  warning: " << warning << std::endl;
      });
      const ReducedUnknowns unknowns(held, {}, MPI_COMM_WORLD);
      for (unsigned int i = 0; i < 2; ++i)
        {
          solver.prepare(unknowns);
          check_solve(solver, unknowns, 1e-6);
        }
    }

    /// For a similar tangent, what has been prepared is kept, unless it fails
    /// or other unknowns are held.
    void
    check_keeping(const std::string &title, const std::vector<Method> &methods)
    {
      output() << title << std::endl;
      TangentSolver solver(*solid, methods, [](const std::string &warning) {
        output() << "  warning: " << warning << std::endl;
      });
      const ReducedUnknowns unknowns(held, {}, MPI_COMM_WORLD);
      solver.prepare(unknowns);
      solver.prepare_for_similar(unknowns);
      check_solve(solver, unknowns, 1e-6);

      const ReducedUnknowns with_top(held_and_top(), {}, MPI_COMM_WORLD);
      solver.prepare_for_similar(with_top);
      check_solve(solver, with_top, 1e-6);
    }

    void
    check_ties(const std::string &title, const unsigned int allowed_surplus)
    {
      output() << title << std::endl;
      const Method  amg = {"AMG", [&]() { return make_amg(); }, 1000};
      TangentSolver solver(*solid, {amg}, [](const std::string &) {});

      const ReducedUnknowns without_ties(held_and_top(), {}, MPI_COMM_WORLD);
      solver.prepare(without_ties);
      const unsigned int n_without = check_solve(solver, without_ties, 1e-9);

      const ReducedUnknowns ties(held, top, MPI_COMM_WORLD);
      solver.prepare(ties);
      verify("  not much worse than held ones, the response unknown",
             check_solve(solver, ties, 1e-9) <= n_without + 5);
      solver.prepare(ties);
      verify("  as good as held ones, the response known",
             check_solve(solver, ties, 1e-9) <= n_without + allowed_surplus);
    }

    /// What an unstable body does is no response to be remembered.
    void
    check_unstable()
    {
      output() << "Negative stiffness" << std::endl;
      const Opposite        opposite(*solid);
      TangentSolver         solver(opposite,
                           {scaling("Scaling", 1e-5, 10000)},
                           [](const std::string &) {});
      const ReducedUnknowns ties(held, top, MPI_COMM_WORLD);
      VectorType            reduced_rhs = rhs, solution = rhs;
      ties.contract(reduced_rhs);
      solver.prepare(ties);
      VectorType difference = solver.known_response();
      ties.expand(difference);
      solver.solve(solution, reduced_rhs, 1e-6);
      difference -= solver.known_response();
      verify("  the response is what it was",
             difference.l2_norm() <= 1e-12 * solver.known_response().l2_norm());
    }

    static Method
    scaling(const std::string &name,
            const double       factor,
            const unsigned int maximum_iterations)
    {
      return {name,
              [=]() { return std::make_unique<Scaling>(name, factor); },
              maximum_iterations};
    }

  private:
    std::vector<unsigned int>
    boundary_entries(const types::boundary_id id, const ComponentMask &mask)
    {
      std::vector<unsigned int> entries;
      for (const auto dof :
           DoFTools::extract_boundary_dofs(dof_handler, mask, {id}))
        if (rhs.in_local_range(dof))
          entries.push_back(rhs.get_partitioner()->global_to_local(dof));
      return entries;
    }

    std::vector<unsigned int>
    held_and_top() const
    {
      std::vector<unsigned int> entries = held;
      entries.insert(entries.end(), top.begin(), top.end());
      return entries;
    }

    std::unique_ptr<TangentPreconditioner>
    make_amg() const
    {
      return std::make_unique<AssembledPreconditioner<dim>>(
        *solid,
        make_algebraic_multigrid(rigid_body_modes(dof_handler, rhs)),
        dof_handler,
        constraints);
    }

    unsigned int
    check_solve(TangentSolver         &solver,
                const ReducedUnknowns &unknowns,
                const double           reduction) const
    {
      VectorType reduced_rhs = rhs, solution = rhs, product = rhs;
      unknowns.contract(reduced_rhs);
      const unsigned int n = solver.solve(solution, reduced_rhs, reduction);
      unknowns.expand(solution);
      solid->vmult(product, solution);
      unknowns.contract(product);
      product -= reduced_rhs;
      verify("  solved", product.l2_norm() / reduced_rhs.l2_norm(), reduction);
      return n;
    }

    parallel::distributed::Triangulation<dim> mesh;
    const FESystem<dim>                       fe;
    DoFHandler<dim>                           dof_handler;
    AffineConstraints<double>                 constraints;
    std::unique_ptr<SolidOperator<dim>>       solid;
    std::vector<unsigned int>                 held, top;
    VectorType                                rhs;
  };
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Block block((MaterialParameters()));
  block.check_fallback("No failure",
                       {Block::scaling("First", 1., 1000),
                        Block::scaling("Second", 1., 1000)});
  block.check_fallback("Too many iterations",
                       {Block::scaling("First", 1., 10),
                        Block::scaling("Second", 1., 1000)});
  block.check_fallback("Values that are not finite",
                       {Block::scaling("First", 0., 1000),
                        Block::scaling("Second", 1., 1000)});
  block.check_fallback("A preconditioner that cannot be prepared",
                       {Block::scaling("First", -1., 1000),
                        Block::scaling("Second", 1., 1000)});
  block.check_keeping("Similar tangents",
                      {Block::scaling("First", 1., 1000),
                       Block::scaling("Second", 1., 1000)});
  block.check_keeping("Similar tangents, too many iterations",
                      {Block::scaling("First", 1., 10),
                       Block::scaling("Second", 1., 1000)});
  block.check_ties("Tied unknowns", 1);
  block.check_unstable();

  Block recovering(recovering_material());
  recovering.flow();
  recovering.check_fallback("Unsymmetric, too many iterations",
                            {Block::scaling("First", 1e-5, 10),
                             Block::scaling("Second", 1e-5, 10000)});
  recovering.check_ties("Unsymmetric, coupled unknowns", 5);
}
