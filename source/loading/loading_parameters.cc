// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/exceptions.h"
#include "loading/loading_parameters.h"

namespace ElastoPlastic
{
  void
  LoadingParameters::add_parameters(ParameterHandler &prm)
  {
    const std::string ramp =
      "A number is reached in proportion to the time t, at the final time; an "
      "expression in t is taken as it is, for instance: ";

    prm.enter_subsection("Loading");
    prm.add_parameter("Control",
                      control,
                      "What drives the indenter. depth: 'Depth' is given, the "
                      "force is a result. force: 'Force' is given, the depth "
                      "is a result.");
    prm.add_parameter("Depth",
                      depth,
                      "delta: how far the indenter is pushed down from where "
                      "it stands undisplaced. With an 'Indenter/Initial gap' "
                      "the first part of the way is through air. " +
                        ramp + "0.02*sin(pi*t). Unit: length.",
                      Patterns::Anything());
    prm.add_parameter("Force",
                      force,
                      "F >= 0: the force that presses the indenter down, for "
                      "'Control = force'; that on the modelled part, where it "
                      "is a half or a quarter. Per unit of thickness in plane "
                      "strain and plane stress, the whole force in an "
                      "axisymmetric body. " +
                        ramp + "50*if(t < 1, t, 2 - t). Unit: force.",
                      Patterns::Anything());
    prm.add_parameter(
      "History",
      history,
      "A table that replaces 'Control', 'Depth', 'Force' and 'Final time': "
      "times with the depth or the force that is reached then, linear in "
      "between, beginning with zero at t = 0. For instance: 1: depth 0.02 | "
      "2: force 0 | 3: depth 0.03. Where the control changes, the new one "
      "starts from what has been reached. A row '4: hold' keeps depth or force; "
      "a material with a rate law creeps or relaxes meanwhile. Rows '5: depth "
      "rate 0.001', '6: force rate 2' and '7: strain rate 0.05' let depth or "
      "force change at this rate until then, and the depth h by the part (dh/dt) "
      "/ h of itself per time. Units: of times, lengths, forces.",
      Patterns::Anything());
    prm.add_parameter(
      "Path",
      path,
      "How far the indenter moves sideways meanwhile, from 'Indenter/Position' "
      "at t = 0: a table of times and displacements, linear in between and "
      "constant after the last, such as 1: 0 | 2: 0.5, in three dimensions with "
      "x and y, such as 1: 0, 0 | 2: 0.5, 0; or an expression in t, in three "
      "dimensions two of them, separated by a semicolon. Empty: the indenter "
      "moves up and down only. Unit: length.",
      Patterns::Anything());
    prm.add_parameter(
      "Number of steps",
      n_steps,
      "The load steps from the virgin state at t = 0 to the final time. 1: "
      "Johnson's stationary problem (Hencky's deformation theory), which is a "
      "different problem from that of many steps. The segments of a 'History', "
      "which the corners of a 'Path' divide further, share the steps in "
      "proportion to their lengths, each gets at least one.",
      Patterns::Integer(1, 1000000));
    prm.add_parameter(
      "Step control",
      step_control,
      "fixed: all steps of a segment are equal, but for those that have to be "
      "cut. adaptive: a segment begins with such a step; after n Newton "
      "iterations the next is longer by the factor sqrt(6/n), at least 1/2 and "
      "at most 2, and never longer than 2 of the 'Number of steps'. Steps end "
      "at the ends of the segments and at 'Output/Field times'. Expressions in "
      "t may turn anywhere: with them, adaptive steps also end where fixed ones "
      "do. accurate: the same, with the factor sqrt('Step tolerance' / error of "
      "the step), up to 64 of the 'Number of steps'; a step that is longer than "
      "one of these and has an error above 4 tolerances is taken back, and half "
      "of it tried.");
    prm.add_parameter(
      "Step tolerance",
      step_tolerance,
      "What 'accurate' steps may deviate, each, from what the step before would "
      "lead to: the part of it that is an error of the implicit Euler method. "
      "Of the force (if that is given, the depth) of the indenter, or without "
      "one of the displacement, relative to the largest until then. Greater "
      "than 0. No unit.",
      Patterns::Double());
    prm.add_parameter(
      "Integration",
      integration,
      "How the flow of the material is integrated over the load steps. backward "
      "Euler: of first order in their length. BDF2: two-step backward "
      "differentiation, of second order, so that a fraction of the steps is "
      "as accurate; the first step is a backward Euler step, and that of each "
      "row of a 'History' that does not go on as the one before: where the "
      "indenter turns, stops, gets another control or becomes more than twice "
      "as fast, where it moves sideways, with loads of other kinds and with "
      "rate laws. Let loads that are expressions of t turn where a row ends. "
      "Not with 'Material/Recovery rates'.");
    prm.add_parameter("Final time",
                      final_time,
                      "The time t at the end of the last step. Greater than 0. "
                      "Unit: time.",
                      Patterns::Double());
    prm.add_parameter("Maximum number of cuts",
                      max_cuts,
                      "A step that does not converge is taken back and "
                      "halved, this many times at most; after success steps "
                      "grow again. A single step is never cut. Adaptive steps "
                      "are not shorter than a step that has been cut so "
                      "often.",
                      Patterns::Integer(0, 30));
    prm.leave_subsection();
  }



  void
  LoadingParameters::check() const
  {
    if (!(step_tolerance > 0))
      throw InputError("Loading/Step tolerance",
                       step_tolerance,
                       "it must be greater than 0, such as 0.002.");
    if (step_control != StepControl::fixed && is_single_step())
      throw InputError(
        "Loading/Step control",
        step_control,
        "a single step is Johnson's stationary problem, which is "
        "solved at once. Choose 'fixed', or a 'Loading/Number "
        "of steps' above 1.");
  }
} // namespace ElastoPlastic
