// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_tangent_solver_h
#define solver_tangent_solver_h

#include <functional>
#include <memory>
#include <string>

#include "solver/mixed_system.h"
#include "solver/reduced_unknowns.h"
#include "solver/tangent_preconditioner.h"

namespace ElastoPlastic
{
  /// What a linear system is made of, and its preconditioner is for.
  enum class TangentForm
  {
    displacements, ///< the tangent itself
    mixed          ///< its mixed form: the part A of it, see TangentOperator
  };



  /// Solves linear systems with a stored tangent, without a matrix, by
  /// preconditioned conjugate gradients, or GMRES if the tangent is
  /// unsymmetric or its mixed form is solved.
  ///
  /// If some unknowns are coupled, all of them count as constrained in the
  /// preconditioner, and their common motion is treated by deflation
  /// @cite tang_nabben_vuik_erlangga_2009: the response of the body to a unit
  /// motion of the coupled unknowns, as far as it is known from earlier
  /// systems, is eliminated exactly. What is left is as easy as without
  /// coupling, but for one outlying eigenvalue if the response is inaccurate.
  class TangentSolver
  {
  public:
    /// A preconditioner, and how long to wait for it.
    struct Method
    {
      /// for the user, such as "geometric multigrid"
      std::string                                             name;
      std::function<std::unique_ptr<TangentPreconditioner>()> make;
      unsigned int maximum_iterations;
      TangentForm  form = TangentForm::displacements;
    };

    /// @p tangent must outlive this object. The first of @p methods is used; it
    /// has failed if it cannot be prepared, its result is not finite or it
    /// needs all its iterations. Then @p warn gets a sentence for the user, and
    /// the next one takes over for good.
    TangentSolver(const TangentOperator                          &tangent,
                  const std::vector<Method>                      &methods,
                  const std::function<void(const std::string &)> &warn)
      : tangent(tangent)
      , methods(methods)
      , warn(warn)
      , method(this->methods.begin())
      , preconditioner(method->make())
    {}


    /// Takes the tangent that is stored now, and which unknowns are constrained
    /// and coupled. @throws ConvergenceError, or FileError if memory is missing
    void
    prepare(const ReducedUnknowns &unknowns);

    /// The same for a tangent that differs little from the one before: as long
    /// as no other unknowns are held, the preconditioner for that one is kept.
    void
    prepare_for_similar(const ReducedUnknowns &unknowns);

    /// Solves until the residual has fallen by the factor @p reduction. Both
    /// vectors are reduced, and zero at eliminated unknowns. @return the
    /// number of iterations. If those of the last method are used up before,
    /// the last iterate is the answer: what has been found by then is still a
    /// direction of descent for the energy or the residual.
    /// @throws ConvergenceError if the result is not finite.
    unsigned int
    solve(VectorType &solution, const VectorType &rhs, const double reduction);

    /// The response learnt so far; without size as long as there is none.
    const VectorType &
    known_response() const
    {
      return response;
    }

    /// Begins with @p known_response, of an earlier solver on the same mesh.
    void
    set_response(const VectorType &known_response);

  private:
    class ReducedTangent;
    class DeflatedPreconditioner;

    /// @throws ConvergenceError if no method is left that can be prepared.
    void
    prepare_preconditioner();

    bool
    is_mixed() const
    {
      return method->form == TangentForm::mixed;
    }

    /// Whether conjugate gradients will do.
    bool
    is_definite() const
    {
      return tangent.is_symmetric() && unknowns.is_symmetric() && !is_mixed();
    }

    bool
    is_last_method() const
    {
      return method + 1 == methods.end();
    }

    void
    take_next_method();

    void
    prepare_response();

    unsigned int
    try_to_solve(VectorType       &solution,
                 const VectorType &rhs,
                 const double      reduction);

    /// The same for the mixed form: @p deflated is for A.
    unsigned int
    try_to_solve_mixed(VectorType                   &solution,
                       const VectorType             &rhs,
                       const DeflatedPreconditioner &deflated,
                       const double                  reduction);

    /// Keeps @p solution as the response if it is better than the present one.
    void
    learn_response(const VectorType &solution, const VectorType &rhs);

    const TangentOperator                         &tangent;
    const std::vector<Method>                      methods;
    const std::function<void(const std::string &)> warn;

    std::vector<Method>::const_iterator    method;
    std::unique_ptr<TangentPreconditioner> preconditioner;
    /// Whether that is for the tangent that is stored now.
    bool is_up_to_date = false;
    /// Of the mixed form.
    std::unique_ptr<const PressurePreconditioner> pressure_preconditioner;

    ReducedUnknowns unknowns;

    /// To a unit motion of the coupled unknowns: expanded, between the systems;
    /// the tangent (in the mixed form A) times the response; and their product,
    /// the response's stiffness. By the minimum principle, the smaller the
    /// better.
    VectorType response, tangent_times_response;
    double     response_stiffness = 0;
  };
} // namespace ElastoPlastic

#endif
