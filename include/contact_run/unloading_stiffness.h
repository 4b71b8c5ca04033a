// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_run_unloading_stiffness_h
#define contact_run_unloading_stiffness_h

#include <deal.II/base/timer.h>

#include <boost/signals2/connection.hpp>

#include <memory>

#include "contact_run/discrete_body.h"
#include "mechanics/solid_operator.h"
#include "output/log.h"
#include "solver/solver_parameters.h"
#include "solver/tangent_solver.h"

namespace ElastoPlastic
{
  /// The stiffness dF/d(depth) with which a small unloading would begin, at
  /// the end of a load step: what a laboratory measures by a small oscillation
  /// (continuous stiffness measurement). All points spring back elastically,
  /// the closed nodes move with the indenter, and with friction none of them
  /// slips. One linear system says what the force is that goes with a unit
  /// motion of the indenter; the run itself is left as it is.
  ///
  /// It is found on a second body with the same mesh and unknowns, whose points
  /// have the present plastic strains and never yield: its tangent is the
  /// elastic one under the present stresses. That body is made anew when the
  /// mesh has changed.
  template <int dim>
  class UnloadingStiffness
  {
  public:
    /// All arguments must outlive this object.
    UnloadingStiffness(const DiscreteBody<dim>      &body,
                       const LinearSolverParameters &linear_solver,
                       Log                          &log,
                       TimerOutput                  &timer);

    /// Of the present displacement, which the material points of the body must
    /// have committed: force per length, of the modelled part. Not a number
    /// without contact, or if the linear system cannot be solved, which the log
    /// then says. Collective.
    double
    compute();

  private:
    void
    take_mesh();

    /// What moves with the indenter and what stays where it is.
    ReducedUnknowns
    unknowns_of_contact() const;

    double
    solve(const ReducedUnknowns &unknowns);

    const DiscreteBody<dim>      &body;
    const LinearSolverParameters &linear_solver;
    Log                          &log;
    TimerOutput                  &timer;

    /// Without value where the mesh is new.
    std::unique_ptr<SolidOperator<dim>> elastic_solid;
    std::unique_ptr<TangentSolver>      tangent_solver;

    boost::signals2::scoped_connection mesh_changes;
  };
} // namespace ElastoPlastic

#endif
