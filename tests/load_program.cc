// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The load over time, and the steps that follow it: segments, cutting, growing;
// which history can go on where another one has got to.

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>

#include <cmath>
#include <sstream>

#include "loading/load_program.h"
#include "loading/loading_parameters.h"
#include "loading/time_steps.h"
#include "refusal.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  std::string
  text(const std::optional<Load> &load)
  {
    if (!load)
      return "not known yet";
    return (load->control == Control::depth ? "depth " : "force ") +
           std::to_string(load->value);
  }



  void
  print_loads(const LoadProgram &program, const std::vector<double> &times)
  {
    for (const double time : times)
      output() << "  t = " << time << ": " << text(program.load(time))
               << std::endl;
  }



  void
  check_expressions()
  {
    LoadingParameters parameters;
    parameters.final_time = 4;
    parameters.depth      = "0.2";
    output() << "A number is reached in proportion to the time" << std::endl;
    print_loads(LoadProgram(parameters), {1, 2, 4});

    parameters.depth = "0.1*sin(pi*t/4)";
    output() << "An expression" << std::endl;
    print_loads(LoadProgram(parameters), {2, 4});

    parameters.control = Control::force;
    parameters.force   = "5*t";
    output() << "A force" << std::endl;
    print_loads(LoadProgram(parameters), {1, 4});

    parameters.final_time = 3;
    parameters.n_steps    = 3;
    parameters.force      = "5*(0.3 - 0.1*t)"; // -3e-16 at the end
    verify("  what rounding leaves of it is zero",
           LoadProgram(parameters).load(3.)->value == 0.);
  }



  LoadProgram
  from_checkpoint(const LoadProgram       &program,
                  const LoadingParameters &parameters)
  {
    std::stringstream             state;
    boost::archive::text_oarchive out(state);
    out << program;
    boost::archive::text_iarchive in(state);
    LoadProgram                   copy(parameters);
    in >> copy;
    return copy;
  }



  void
  check_history()
  {
    LoadingParameters parameters;
    parameters.history =
      "1: depth 0.2 | 1.5: force 0 | 2: force 8 | 3: depth 1";
    LoadProgram program(parameters);
    output() << "A table; it begins at zero" << std::endl;
    verify("  final time", program.final_time() == 3);
    print_loads(program, {0.5, 1});
    output() << "  where the control changes, it depends on what is reached"
             << std::endl;
    print_loads(program, {1.25, 1.5, 1.75, 2, 2.5, 3});
    program.reached(0.5, 0.1, 20.);
    program.reached(1., 0.2, 30.);
    print_loads(program, {1.25, 1.5, 1.75, 2, 2.5});
    output() << "  the same from a checkpoint" << std::endl;
    print_loads(from_checkpoint(program, parameters), {1.25, 2.5});
    program.reached(1.5, 0.15, 0.);
    program.reached(2., 0.4, 8.);
    print_loads(program, {2.5, 3});
    output() << "  and from a changed mesh" << std::endl;
    program.reached(2., 0.6, 8.);
    print_loads(program, {2.5, 3});
  }



  void
  check_holds()
  {
    output() << "Nothing happens" << std::endl;
    LoadingParameters parameters;
    parameters.history =
      "1: force 2 | 1.5: hold | 2: depth 1 | 3: hold | 4: depth 1";
    const LoadProgram program(parameters);
    print_loads(program, {1.25, 1.5, 2.5, 3, 4});
    for (const auto &[begin, end] : program.holds())
      output() << "  from t = " << begin << " to " << end << std::endl;
  }



  /// Where it goes on in the same direction, and how fast.
  void
  check_changes_of_pace()
  {
    const auto print = [](const std::string &history, const std::string &path) {
      LoadingParameters parameters;
      parameters.history = history;
      parameters.path    = path;
      LoadProgram program(parameters);
      program.reached(3., 0.4, 8.);
      output() << "Changes of pace in " << history
               << (path.empty() ? "" : ", sideways") << std::endl;
      for (const double time : program.segment_ends())
        if (const auto pace = program.change_of_pace(time))
          output() << "  t = " << time << ": " << *pace << std::endl;
    };
    const std::string onwards = "1: depth 0.1 | 2: depth 0.3";
    print(onwards, "");
    print(onwards, "1: 0 | 2: 0.5");
    print(
      "1: depth 0.1 | 2: strain rate 0.5 | 3: depth 0.4 | 4: force 2 | 5: "
      "force 1.5 | 6: hold | 7: force 1",
      "");
  }



  void
  check_rates()
  {
    LoadingParameters parameters;
    parameters.history =
      "1: depth rate 0.1 | 2: strain rate 0.5 | 3: depth rate -0.05 | 4: hold "
      "| 5: force 2 | 6: force rate 3 | 7: hold | 8: strain rate -0.2 | 9: "
      "depth rate 0.1 | 10: depth 1";
    LoadProgram program(parameters);
    output() << "At given rates" << std::endl;
    verify("  turning at the ends of segments only",
           program.turns_at_segment_ends_only());
    print_loads(program, {0.5, 1, 1.5, 2, 3, 3.5, 4, 5, 5.5, 6, 7});
    for (const auto &[begin, end] : program.holds())
      output() << "  hold from t = " << begin << " to " << end << std::endl;
    output() << "  after a force, they depend on what is reached, up to the "
                "next value"
             << std::endl;
    print_loads(program, {7.5, 8, 8.5, 9, 9.5, 10});
    program.reached(7., 0.5, 5.);
    print_loads(program, {7.5, 8, 8.5, 9, 9.5, 10});
    output() << "  the same from a checkpoint" << std::endl;
    print_loads(from_checkpoint(program, parameters), {8.5, 9.5});

    parameters.history = "1: depth 0.1 | 2: force rate -3 | 3: depth 1";
    LoadProgram pulling(parameters);
    pulling.reached(1., 0.1, 2.);
    print_loads(pulling, {1.5});
    print_error("A force that becomes negative", [&]() { pulling.load(2.); });
    parameters.history = "1: force 1 | 2: strain rate 0.5";
    LoadProgram growing(parameters);
    growing.reached(1., -0.1, 1.);
    print_error("Nothing that could grow", [&]() { growing.load(2.); });
  }



  /// How a history goes on that begins with @p before.
  void
  print_answer(const std::string       &what,
               const LoadingParameters &before,
               const LoadingParameters &now,
               const double             time)
  {
    output() << "  " << what << ": "
             << refusal([&]() { check_same_past(before, now, time); }, "ok")
             << std::endl;
  }



  void
  check_pasts()
  {
    output() << "Loaded in four steps until t = 1" << std::endl;
    LoadingParameters before;
    before.depth   = "0.2";
    before.n_steps = 4;

    LoadingParameters now = before;
    now.final_time        = 2;
    print_answer("longer steps", before, now, 1.);
    now.n_steps = 8;
    print_answer("less depth", before, now, 1.);
    now.depth = "0.4";
    print_answer("twice as long", before, now, 1.);
    now.depth = "0.2*t";
    print_answer("an expression", before, now, 1.);
    now.depth = "0.2*if(t < 0.6, t, 1.2 - t)";
    print_answer("turning earlier", before, now, 1.);
    print_answer("turning later", before, now, 0.5);
    now.history = "1: depth 0.2 | 2: force 0";
    print_answer("unloaded", before, now, 1.);
    now.control = Control::force;
    now.history = "";
    print_answer("by force", before, now, 1.);
    now            = before;
    now.final_time = 0.5;
    now.n_steps    = 2;
    now.depth      = "0.1";
    print_answer("shorter", before, now, 1.);

    before.history = "1: depth 0.1 | 2: force  rate 3 | 4: force rate 0";
    now            = before;
    now.history    = "1: depth 0.1 | 2: force rate 3 | 4: force rate 1";
    print_answer("another rate in future", before, now, 2.);
    print_answer("another rate under way", before, now, 3.);
    now.history = "1: depth 0.1 | 2: force rate 4 | 4: force rate 0";
    print_answer("another rate in the past", before, now, 3.);
  }



  void
  print_steps(TimeSteps steps, const std::vector<unsigned int> &failures)
  {
    for (unsigned int attempt = 1; !steps.finished(); ++attempt)
      {
        output() << "  step " << steps.number() << ": " << steps.time()
                 << " to " << steps.next_time();
        if (std::count(failures.begin(), failures.end(), attempt) > 0)
          output() << ", fails" << (steps.cut() ? "" : ", cannot be cut")
                   << std::endl;
        else
          {
            output() << std::endl;
            steps.advance();
          }
      }
    output() << "  end: " << steps.time() << std::endl;
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_expressions();
  check_history();
  check_holds();
  check_changes_of_pace();
  check_rates();
  check_pasts();

  output() << "Three steps" << std::endl;
  print_steps(TimeSteps({3.}, 3, 4), {});
  output() << "Segments share the steps, each has at least one" << std::endl;
  print_steps(TimeSteps({1., 1.1, 3.}, 4, 4), {});
  output() << "Cut twice, then growing again" << std::endl;
  print_steps(TimeSteps({2.}, 2, 4), {1, 2, 4});
  output() << "As short as it may be" << std::endl;
  print_steps(TimeSteps({2.}, 2, 1), {1, 2});

  TimeSteps many({1.}, 1000, 6);
  double    largest_error = 0;
  for (; !many.finished(); many.advance())
    largest_error =
      std::max(largest_error, std::abs(many.next_time() - many.number() / 1e3));
  verify("A thousand steps without drift", largest_error, 1e-15);
}
