// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "solver/conjugate_gradients.h"
#include "solver/minimal_residuals.h"
#include "solver/tangent_solver.h"

namespace ElastoPlastic
{
  /// E^T A E, on reduced vectors.
  template <int dim>
  class TangentSolver<dim>::ReducedTangent
  {
  public:
    ReducedTangent(const SolidOperator<dim> &solid,
                   const ReducedUnknowns    &unknowns)
      : solid(solid)
      , unknowns(unknowns)
    {}

    void
    vmult(VectorType &result, const VectorType &vector) const
    {
      if (unknowns.has_ties())
        {
          expanded = vector;
          unknowns.expand(expanded);
          solid.vmult(result, expanded);
        }
      else
        solid.vmult(result, vector);
      unknowns.contract(result);
    }

  private:
    const SolidOperator<dim> &solid;
    const ReducedUnknowns    &unknowns;
    mutable VectorType        expanded;
  };



  /// Q + (1 - Q A) M (1 - A Q), where M is the given preconditioner and Q = d
  /// d^T / (d^T A d) solves exactly along the response d. (If A is unsymmetric,
  /// (A d)^T stands for d^T A.)
  template <int dim>
  class TangentSolver<dim>::DeflatedPreconditioner
  {
  public:
    explicit DeflatedPreconditioner(const TangentSolver<dim> &solver)
      : solver(solver)
    {}

    void
    vmult(VectorType &result, const VectorType &vector) const
    {
      if (!solver.unknowns.has_ties())
        {
          solver.preconditioner->vmult(result, vector);
          return;
        }
      const double along =
        (solver.response * vector) / solver.response_stiffness;
      remainder = vector;
      remainder.add(-along, solver.tangent_times_response);
      solver.unknowns.set_entries(remainder, 0.);
      solver.preconditioner->vmult(result, remainder);
      result.add(along - (solver.tangent_times_response * result) /
                           solver.response_stiffness,
                 solver.response);
    }

  private:
    const TangentSolver<dim> &solver;
    mutable VectorType        remainder;
  };



  template <int dim>
  TangentSolver<dim>::TangentSolver(
    const std::vector<Method>                      &methods,
    const std::function<void(const std::string &)> &warn)
    : methods(methods)
    , warn(warn)
    , method(this->methods.begin())
    , preconditioner(method->make())
  {}



  template <int dim>
  void
  TangentSolver<dim>::prepare(const SolidOperator<dim> &new_solid,
                              const ReducedUnknowns    &new_unknowns)
  {
    solid    = &new_solid;
    unknowns = new_unknowns;
    prepare_preconditioner();
    if (unknowns.has_ties())
      prepare_response();
  }



  template <int dim>
  void
  TangentSolver<dim>::set_response(const VectorType &known_response)
  {
    response = known_response;
    tangent_times_response.reinit(response);
  }



  template <int dim>
  void
  TangentSolver<dim>::prepare_preconditioner()
  {
    VectorType held;
    solid->initialize_vector(held);
    unknowns.set_entries(held, 1.);
    while (true)
      try
        {
          preconditioner->prepare(*solid, held);
          return;
        }
      catch (const ConvergenceError &)
        {
          if (is_last_method())
            throw;
          take_next_method();
        }
  }



  template <int dim>
  void
  TangentSolver<dim>::take_next_method()
  {
    const std::string failed = method->name;
    ++method;
    warn((solid->has_energy() ? "Conjugate gradients with " + failed + " do" :
                                "GMRES with " + failed + " does") +
         " not converge here: " + method->name + " takes over on this mesh.");
    preconditioner = method->make();
  }



  // As long as nothing better is known, the response is that of the tied
  // unknowns alone.
  template <int dim>
  void
  TangentSolver<dim>::prepare_response()
  {
    if (response.size() == 0)
      {
        solid->initialize_vector(response);
        solid->initialize_vector(tangent_times_response);
      }
    unknowns.set_leading_value(response, 1.);
    ReducedTangent(*solid, unknowns).vmult(tangent_times_response, response);
    response_stiffness = response * tangent_times_response;
  }



  template <int dim>
  unsigned int
  TangentSolver<dim>::solve(VectorType       &solution,
                            const VectorType &rhs,
                            const double      reduction)
  {
    while (!is_last_method())
      {
        try
          {
            const unsigned int n = try_to_solve(solution, rhs, reduction);
            if (n < method->maximum_iterations)
              return n;
          }
        catch (const ConvergenceError &)
          {}
        take_next_method();
        prepare_preconditioner();
      }
    return try_to_solve(solution, rhs, reduction);
  }



  template <int dim>
  unsigned int
  TangentSolver<dim>::try_to_solve(VectorType       &solution,
                                   const VectorType &rhs,
                                   const double      reduction)
  {
    const ReducedTangent         tangent(*solid, unknowns);
    const DeflatedPreconditioner deflated(*this);
    const unsigned int           max_n = method->maximum_iterations;
    const unsigned int           n =
      solid->has_energy() ?
                  conjugate_gradients(
          tangent, solution, rhs, deflated, reduction, max_n) :
                  minimal_residuals(tangent, solution, rhs, deflated, reduction, max_n);
    if (unknowns.has_ties())
      learn_response(solution, rhs);
    return n;
  }



  // CG is a Galerkin method: solution^T A solution = solution^T rhs. (With
  // GMRES, both sides agree as far as the residual has fallen.)
  template <int dim>
  void
  TangentSolver<dim>::learn_response(const VectorType &solution,
                                     const VectorType &rhs)
  {
    const double motion    = unknowns.leading_value(solution);
    const double stiffness = (solution * rhs) / (motion * motion);
    if (std::isfinite(stiffness) && stiffness < response_stiffness)
      response.equ(1. / motion, solution);
    unknowns.expand(response);
  }



  template class TangentSolver<2>;
  template class TangentSolver<3>;
} // namespace ElastoPlastic
