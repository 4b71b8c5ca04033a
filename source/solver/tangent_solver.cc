// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "solver/krylov_methods.h"
#include "solver/tangent_solver.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The mixed form needs more steps than a definite system, and restarts
    /// cost it more.
    constexpr unsigned int n_basis_vectors_of_mixed_form = 100;
  } // namespace



  /// The tangent with ReducedUnknowns, on reduced vectors.
  class TangentSolver::ReducedTangent
  {
  public:
    ReducedTangent(const TangentOperator &tangent,
                   const ReducedUnknowns &unknowns)
      : tangent(tangent)
      , unknowns(unknowns)
    {}

    void
    vmult(VectorType &result, const VectorType &vector) const
    {
      if (!unknowns.is_trivial())
        {
          expanded = vector;
          unknowns.expand(expanded);
          tangent.vmult(result, expanded);
          unknowns.reduce_product(result, expanded, vector);
          return;
        }
      tangent.vmult(result, vector);
      unknowns.contract(result);
    }

  private:
    const TangentOperator &tangent;
    const ReducedUnknowns &unknowns;
    mutable VectorType     expanded;
  };



  /// Q + (1 - Q A) M (1 - A Q), where M is the given preconditioner and Q = d
  /// d^T / (d^T A d) solves exactly along the response d. (If A is unsymmetric,
  /// (A d)^T stands for d^T A.)
  class TangentSolver::DeflatedPreconditioner
  {
  public:
    explicit DeflatedPreconditioner(const TangentSolver &solver)
      : solver(solver)
    {}

    void
    vmult(VectorType &result, const VectorType &vector) const
    {
      if (!solver.unknowns.has_coupling())
        {
          precondition(result, vector);
          return;
        }
      const double along =
        (solver.response * vector) / solver.response_stiffness;
      remainder = vector;
      remainder.add(-along, solver.tangent_times_response);
      solver.unknowns.set_entries(remainder, 0.);
      precondition(result, remainder);
      result.add(along - (solver.tangent_times_response * result) /
                           solver.response_stiffness,
                 solver.response);
    }

  private:
    void
    precondition(VectorType &result, const VectorType &forces) const
    {
      if (!solver.unknowns.have_entering())
        {
          solver.preconditioner->vmult(result, forces);
          return;
        }
      released = forces;
      solver.unknowns.release_entering(released);
      solver.preconditioner->vmult(result, released);
      solver.unknowns.bind_entering(result);
    }

    const TangentSolver &solver;
    mutable VectorType   remainder, released;
  };



  void
  TangentSolver::prepare(const ReducedUnknowns &new_unknowns)
  {
    unknowns = new_unknowns;
    prepare_preconditioner();
    if (unknowns.has_coupling())
      prepare_response();
  }



  void
  TangentSolver::prepare_for_similar(const ReducedUnknowns &new_unknowns)
  {
    if (!new_unknowns.are_held_as_in(unknowns))
      {
        prepare(new_unknowns);
        return;
      }
    unknowns      = new_unknowns;
    is_up_to_date = false;
    if (unknowns.has_coupling())
      prepare_response();
  }



  void
  TangentSolver::set_response(const VectorType &known_response)
  {
    response = known_response;
    tangent_times_response.reinit(response);
  }



  void
  TangentSolver::prepare_preconditioner()
  {
    HeldUnknowns held;
    tangent.initialize_vector(held.constrained);
    unknowns.set_entries(held.constrained, 1.);
    if (unknowns.have_slopes())
      {
        tangent.initialize_vector(held.slopes);
        unknowns.set_slopes(held.slopes);
      }
    if (unknowns.have_entering())
      {
        tangent.initialize_vector(held.springs);
        unknowns.set_springs(held.springs);
        held.shared = unknowns.shared_forces();
      }
    while (true)
      try
        {
          preconditioner->prepare(held);
          if (is_mixed())
            pressure_preconditioner =
              tangent.make_pressure_preconditioner(held.constrained);
          is_up_to_date = true;
          return;
        }
      catch (const ConvergenceError &)
        {
          if (is_last_method())
            throw;
          take_next_method();
        }
  }



  void
  TangentSolver::take_next_method()
  {
    const std::string failed =
      is_definite() ? "Conjugate gradients with " + method->name + " do" :
                      "GMRES with " + method->name + " does";
    ++method;
    pressure_preconditioner.reset();
    warn(failed + " not converge here: " + method->name +
         " takes over on this mesh.");
    preconditioner = method->make();
  }



  // As long as nothing better is known, the response is that of the coupled
  // unknowns alone.
  void
  TangentSolver::prepare_response()
  {
    if (response.size() == 0)
      {
        tangent.initialize_vector(response);
        tangent.initialize_vector(tangent_times_response);
      }
    unknowns.reduce_motion(response, 1.);
    if (is_mixed())
      MixedSystem(tangent, unknowns)
        .vmult_moderate(tangent_times_response, response);
    else
      ReducedTangent(tangent, unknowns).vmult(tangent_times_response, response);
    response_stiffness = response * tangent_times_response;
  }



  // (A preconditioner that has been kept too long is no failure of its method.)
  unsigned int
  TangentSolver::solve(VectorType       &solution,
                       const VectorType &rhs,
                       const double      reduction)
  {
    while (!is_last_method() || !is_up_to_date)
      {
        try
          {
            const unsigned int n = try_to_solve(solution, rhs, reduction);
            if (n < method->maximum_iterations)
              return n;
          }
        catch (const ConvergenceError &)
          {}
        if (is_up_to_date)
          take_next_method();
        prepare(ReducedUnknowns(unknowns));
      }
    return try_to_solve(solution, rhs, reduction);
  }



  unsigned int
  TangentSolver::try_to_solve(VectorType       &solution,
                              const VectorType &rhs,
                              const double      reduction)
  {
    const ReducedTangent         reduced(tangent, unknowns);
    const DeflatedPreconditioner deflated(*this);
    const unsigned int           max_n = method->maximum_iterations;
    const unsigned int           n =
      is_mixed() ?
                  try_to_solve_mixed(solution, rhs, deflated, reduction) :
                is_definite() ?
                  conjugate_gradients(
          reduced, solution, rhs, deflated, reduction, max_n) :
                  flexible_gmres(reduced, solution, rhs, deflated, reduction, max_n);
    if (unknowns.has_coupling())
      learn_response(solution, rhs);
    return n;
  }



  unsigned int
  TangentSolver::try_to_solve_mixed(VectorType                   &solution,
                                    const VectorType             &rhs,
                                    const DeflatedPreconditioner &deflated,
                                    const double                  reduction)
  {
    // Krylov methods want a name for what preconditions.
    struct Preconditioner
    {
      const MixedSystem            &system;
      const DeflatedPreconditioner &deflated;
      const PressurePreconditioner &solve_pressures;

      void
      vmult(BlockVectorType &result, const BlockVectorType &vector) const
      {
        system.precondition(
          result,
          vector,
          [&](VectorType &u, const VectorType &forces) {
            deflated.vmult(u, forces);
          },
          solve_pressures);
      }
    };

    MixedSystem system(tangent, unknowns);
    system.scale_pressures(rhs);
    BlockVectorType mixed_solution, mixed_rhs;
    system.initialize_vector(mixed_solution);
    system.initialize_vector(mixed_rhs);
    mixed_rhs.block(0) = rhs;
    const unsigned int n =
      flexible_gmres(system,
                     mixed_solution,
                     mixed_rhs,
                     Preconditioner{system, deflated, *pressure_preconditioner},
                     reduction / std::sqrt(2.),
                     method->maximum_iterations,
                     n_basis_vectors_of_mixed_form);
    solution = mixed_solution.block(0);
    return n;
  }



  // CG is a Galerkin method: solution^T A solution = solution^T rhs. (With
  // GMRES, both sides agree as far as the residual has fallen.)
  void
  TangentSolver::learn_response(const VectorType &solution,
                                const VectorType &rhs)
  {
    const double motion    = unknowns.leading_value(solution);
    const double stiffness = (solution * rhs) / (motion * motion);
    if (stiffness > 0. && stiffness < response_stiffness)
      response.equ(1. / motion, solution);
    unknowns.expand(response);
  }
} // namespace ElastoPlastic
