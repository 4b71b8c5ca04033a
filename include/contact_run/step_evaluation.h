// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_run_step_evaluation_h
#define contact_run_step_evaluation_h

#include "contact_run/discrete_body.h"
#include "contact_run/last_step.h"
#include "evaluation/imprint.h"
#include "evaluation/probes.h"
#include "evaluation/step_guards.h"
#include "loads/reactions.h"
#include "output/log.h"
#include "output/output_parameters.h"
#include "output/run_tables.h"

namespace ElastoPlastic
{
  /// What the tables say of a solution: loads and energies, the imprint,
  /// whether forces balance, the reactions of the supports, probes; and what
  /// there is to warn of. It changes nothing of the body.
  template <int dim>
  class StepEvaluation
  {
  public:
    /// All arguments must outlive this object. Collective. @throws InputError
    /// for probes and profile lines that do not fit the body.
    StepEvaluation(const OutputParameters  &parameters,
                   const DiscreteBody<dim> &body,
                   Log                     &log,
                   TimerOutput             &timer);

    /// Every profile line must meet the contact surface. Collective.
    /// @throws InputError
    void
    check_lines() const
    {
      imprint.check_lines(body.contact_surface());
    }

    const NominalContact<dim> &
    nominal_contact() const
    {
      return contact;
    }

    /// What the columns of the tables are called.
    RunTables::Names
    names() const;

    /// Fills in all of @p result that follows from the present solution.
    /// Collective. @return the sum of the magnitudes of all nodal forces.
    /// @throws ConvergenceError if the body flows without end
    double
    measure(SolveResult &result, const LastStep &last_step) const;

    /// What the tables say of the end of a step with this @p result (which the
    /// return value refers to), before the material points take it as the
    /// beginning of the next one. Collective.
    StepResult
    of_step(const SolveResult &result) const;

    /// A load step has ended with @p result, and is @p last_step now. Warns of
    /// elements that are too few for the contact. Collective.
    void
    note(const SolveResult &result, const LastStep &last_step);

    /// Warns if rounding has prevented the solver from meeting its
    /// @p tolerance.
    void
    warn_of_residual(const SolveResult &result, const double tolerance) const;

    /// Warns if @p result has left the theory of small strains, with each limit
    /// once, and, once, of pressures that cannot be. Collective.
    void
    warn_of_limits(const SolveResult &result);

    /// The same without a word: that has been said.
    void
    do_not_repeat(const SolveResult &result);

    /// What has been noted, for checkpoints.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &imprint;
    }

  private:
    /// The nodal forces of the indenter on the body.
    VectorType
    contact_forces() const
    {
      return body.contact_evaluation().forces_on_body();
    }

    /// What to say of an indenter that has entered the body without touching
    /// it, or nothing. Collective.
    std::string
    warning_of_missed_contact() const;

    /// Under a prescribed force. (Depths are looked at before the run:
    /// check_depth().) Collective.
    void
    warn_of_depth(const SolveResult &result);

    void
    warn_of_large_strains(const SolveResult &result);

    /// Collective.
    void
    warn_of_pressure(const SolveResult &result);

    void
    require_bounded_flow(const SolveResult &result) const;

    void
    measure_elements(SolveResult &result, const SolveResult &before) const;

    /// @return the sum of the magnitudes of all nodal forces.
    double
    check_force_balance(SolveResult &result, const double largest_before) const;

    bool
    writes_surface_profile(const double time) const;

    const OutputParameters  &parameters;
    const DiscreteBody<dim> &body;
    Log                     &log;
    TimerOutput             &timer;

    const Reactions<dim>             reactions;
    const BoundaryDisplacements<dim> boundary_displacements;
    const ProbePoints<dim>           probe_points;
    const NominalContact<dim>        contact;
    Imprint<dim>                     imprint;
    SmallStrainGuard<dim>            small_strain_guard;
    PressureGuard                    pressure_guard;
  };
} // namespace ElastoPlastic

#endif
