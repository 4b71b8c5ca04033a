// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_run_load_step_h
#define contact_run_load_step_h

#include <algorithm>
#include <optional>

#include "base/exceptions.h"
#include "contact_run/discrete_body.h"
#include "contact_run/last_step.h"
#include "input/parameters.h"
#include "loading/load_program.h"
#include "loading/time_steps.h"

namespace ElastoPlastic
{
  /// The load step under way, from the equilibrium that the last one has left.
  /// Where the history is, and what a step does to the body, is decided here
  /// and nowhere else: a step begins, and then it is either committed or taken
  /// back. Between two steps, the mesh may change.
  ///
  /// All functions are collective.
  template <int dim>
  class LoadStep
  {
  public:
    /// Before the first step. All arguments must outlive this object.
    LoadStep(const Model<dim>  &model,
             const Parameters  &parameters,
             DiscreteBody<dim> &body)
      : model(model)
      , parameters(parameters)
      , body(body)
      , load_program(model.load_program)
      , time_steps(make_time_steps(model, parameters))
    {}


    /// Makes the body on its first mesh, for this step.
    void
    make_body();

    /// Lets the body be loaded as at the end of the step, and guesses how it
    /// will look then.
    void
    begin();

    /// The body is in equilibrium, with this @p result, which gets the work
    /// that has been done in the step and what has been summed up before: from
    /// now on, this is the last step.
    void
    commit(SolveResult &result);

    /// Whether accurate steps have become so long that this one, in equilibrium
    /// with this @p result, errs by more than their tolerance allows: it is to
    /// be taken back, and half of it to be tried.
    bool
    is_too_inaccurate(const SolveResult &result) const;

    /// The body is what it was after the last step. (The material points have
    /// not forgotten it.)
    void
    take_back();

    /// Lets the next attempt go half as far. @return false if it is as short
    /// as it may be.
    bool
    halve();

    /// On to the next step, after one of @p n_iterations of Newton's method.
    void
    advance(const unsigned int n_iterations);

    /// Obeys the flags of the body's cells: the next mesh for the present
    /// state.
    void
    change_mesh();

    /// After a change of the mesh between steps: lets the interpolated state be
    /// what the next step begins with, in the absence of an equilibrium.
    void
    commit_interpolated();

    /// The same of the equilibrium on the new mesh under the same load, which
    /// has been found with this @p result. The work for it is none of the load.
    void
    commit_on_new_mesh(SolveResult result);

    /// The body has borne nodal forces, the sum of whose magnitudes is
    /// @p forces.
    void
    note_forces(const double forces)
    {
      last_step.largest_forces = std::max(last_step.largest_forces, forces);
    }

    /// Writes the mesh with what is kept in its cells; see serialize().
    /// @throws FileError
    void
    save(const std::string &mesh_file)
    {
      body.save(last_step, mesh_file);
    }

    /// Takes back the body as it was after the last step, of which the rest has
    /// been read already. @throws InputError, FileError
    void
    restore(const std::string &mesh_file);

    /// What is not in the cells of the mesh, for checkpoints.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &time_steps &load_program &mesh_number &last_step
        &has_been_halved;
    }

    /// Its place in the history.
    const TimeSteps &
    times() const
    {
      return time_steps;
    }

    /// The load of the indenter at its end.
    Load
    load() const
    {
      return load_program.load(time_steps.next_time()).value();
    }

    /// The equilibrium that it begins with.
    const LastStep &
    last() const
    {
      return last_step;
    }

    /// How many meshes there have been before the present one.
    unsigned int
    cycle() const
    {
      return mesh_number;
    }

    /// Whether there is nothing before it that could be kept.
    bool
    is_first() const
    {
      return time_steps.number() == 1;
    }

    /// Whether it has been committed before a checkpoint: the history was
    /// complete then, and may have become longer.
    bool
    is_done() const
    {
      return last_step.result.step == time_steps.number();
    }

    bool
    is_under_way() const
    {
      return under_way;
    }

    /// Whether the last one was the last of the history.
    bool
    is_history_complete() const
    {
      return last_step.result.time == load_program.final_time();
    }

    /// It has failed with @p error, however short it was made. If the body's
    /// materials stop hardening, it has a limit load; if also force or
    /// tractions were to grow, then that has been reached.
    /// @throws EquilibriumError then, ConvergenceError otherwise
    [[noreturn]] void
    give_up(const ConvergenceError &error) const;

  private:
    /// Before the first step: the nodal forces of the initial stress on the
    /// present mesh, if there is one.
    void
    take_initial_forces();

    /// How long the last step would have to go on for what this one does: its
    /// duration, but where the indenter has changed its pace. None where the
    /// load has turned, or goes on by more than twice as much in a step.
    std::optional<double>
    duration_at_last_pace() const;

    /// Whether there are rates that it may be expected to go on with. (Finite
    /// strains need a guess as soon as there is one: a surface that moves alone
    /// would crush the elements below. Otherwise, what has failed with a guess
    /// is tried without, and a first step from nothing is no guess.)
    bool
    has_rates() const
    {
      return model.strain_model.is_finite() ?
               !is_first() :
               time_steps.number() > 2 && !has_been_halved;
    }

    /// Of the committed @p result, in what accurate steps allow.
    double
    error_of(const SolveResult &result) const;

    /// What to say if no limit load explains it.
    ConvergenceError
    failure(const ConvergenceError &error) const;

    /// Since the last step: tractions do not grow if they only become smaller.
    /// The virgin body bears none, unless it has an initial stress.
    bool
    tractions_grow() const;

    const Model<dim>  &model;
    const Parameters  &parameters;
    DiscreteBody<dim> &body;

    LoadProgram  load_program;
    TimeSteps    time_steps;
    unsigned int mesh_number = 0;
    LastStep     last_step;
    bool         under_way = false, has_been_halved = false;
  };
} // namespace ElastoPlastic

#endif
