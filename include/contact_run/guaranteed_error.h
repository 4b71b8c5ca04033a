// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_run_guaranteed_error_h
#define contact_run_guaranteed_error_h

#include <functional>
#include <memory>
#include <string>

#include "contact_run/discrete_body.h"
#include "input/parameters.h"
#include "output/log.h"

namespace ElastoPlastic
{
  /// What a contact problem, in one step from the virgin state, asks of who can
  /// bound its error (ErrorBoundAnalysis in bounds/, which need not be there).
  template <int dim>
  class GuaranteedError
  {
  public:
    virtual ~GuaranteedError() = default;

    /// A solution of the displacement method on one mesh.
    struct Solution
    {
      const DoFHandler<dim> &dof_handler;
      const VectorType      &displacement;
      Load                   load;  ///< what has been prescribed, at @p time
      double                 depth; ///< of the indenter, given or found
      double                 force; ///< likewise
      double                 time;
      unsigned int           cycle;
    };

    /// Solves the displacement method on the same mesh for another depth.
    /// Collective. @throws ConvergenceError
    using DisplacementAt = std::function<VectorType(const double depth)>;

    /// Computes the bound and those of force or depth, and adds a row to
    /// error_bound.csv. Collective. @return the bound of the norm of the
    /// difference between the exact stresses and those in equilibrium,
    /// sqrt(int (sigma - tau) : C^-1 (sigma - tau) dx); infinity if none has
    /// been found. @throws FileError
    virtual double
    evaluate(const Solution       &solution,
             const DisplacementAt &displacement_at) = 0;

    /// The parts of the last bound, for each active cell of this rank; the
    /// squares add up to that of the bound. If the load is the goal of the
    /// refinement: those of the distance between its bounds.
    virtual const Vector<float> &
    indicators() const = 0;

    /// Why there is no bound of the last solution; empty if there is.
    virtual const std::string &
    why_missing() const = 0;

    /// Writes the fields that the last bound has been computed from, to
    /// equilibrium-*.vtu. @throws FileError
    virtual void
    write_fields(const unsigned int cycle) = 0;
  };



  /// For the bodies of a run, which outlive the result; that on the first mesh
  /// is looked at, and the log told what to know of it. Collective.
  /// @throws InputError if there can be no bound
  template <int dim>
  using MakeGuaranteedError =
    std::function<std::unique_ptr<GuaranteedError<dim>>(
      const DiscreteBody<dim> &, const Parameters &, Log &)>;
} // namespace ElastoPlastic

#endif
