// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Load steps that adapt to the iterations of Newton's method: how they grow and
// shrink, where they end, and that they do not depend on an interruption.

#include <deal.II/base/mpi.h>

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "loading/time_steps.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// The iterations of each attempt; it fails if there are none.
  using Attempts = std::vector<unsigned int>;



  void
  print_steps(const std::string &what, TimeSteps steps, Attempts attempts)
  {
    output() << what << std::endl;
    for (const unsigned int n_iterations : attempts)
      {
        output() << "  step " << steps.number() << ": " << steps.time()
                 << " to " << steps.next_time() << ", ";
        if (n_iterations > 0)
          {
            output() << n_iterations << " iterations" << std::endl;
            steps.advance(n_iterations);
          }
        else
          output() << "fails" << (steps.cut() ? "" : ", cannot be cut")
                   << std::endl;
      }
    output() << (steps.finished() ? "  end: " : "  and so on from ")
             << steps.time() << std::endl;
  }



  TimeSteps
  copy_from_checkpoint(const TimeSteps &steps, TimeSteps copy)
  {
    std::stringstream             state;
    boost::archive::text_oarchive out(state);
    out << steps;
    boost::archive::text_iarchive in(state);
    in >> copy;
    return copy;
  }



  /// Whatever happens: stops are ends of steps, a step that does not begin or
  /// end at one is within the limits of length, and a copy takes the same ways.
  void
  check_random_histories()
  {
    const std::vector<double> segments = {0.7, 1.9, 2., 3.};
    const std::vector<double> stops    = {0.3, 1.9, 2.1234567, 5.};
    const TimeSteps fresh(segments, 30, 3, StepControl::adaptive, stops);

    std::mt19937 random(1);
    double       shortest = 1, longest = 0;
    bool         stop_is_missed = false, copy_differs = false;
    for (unsigned int run = 0; run < 1000; ++run)
      {
        TimeSteps           steps = fresh;
        std::vector<double> ends  = {0.};
        while (!steps.finished())
          {
            if (random() % 5 == 0)
              steps.cut();
            const double       end          = steps.next_time();
            const unsigned int n_iterations = random() % 30;
            TimeSteps          copy = copy_from_checkpoint(steps, fresh);
            copy.advance(n_iterations);
            steps.advance(n_iterations);
            copy_differs |= copy.time() != steps.time() ||
                            copy.next_time() != steps.next_time();
            copy_differs |= steps.time() != end;
            ends.push_back(end);
          }
        for (const double stop : {0.3, 0.7, 1.9, 2., 2.1234567, 3.})
          stop_is_missed |=
            std::none_of(ends.begin(), ends.end(), [&](const double end) {
              return std::abs(end - stop) < 1e-14;
            });
        // (the last segment has ten steps, and a stop close to its begin)
        for (unsigned int i = 1; i < ends.size(); ++i)
          if (ends[i - 1] > 2.1234568 && ends[i] < 2.9999)
            {
              shortest = std::min(shortest, ends[i] - ends[i - 1]);
              longest  = std::max(longest, ends[i] - ends[i - 1]);
            }
      }
    output() << "Whatever happens" << std::endl;
    verify("  steps end at every stop", !stop_is_missed);
    verify("  a checkpoint makes no difference", !copy_differs);
    verify("  no step is much shorter than the shortest",
           shortest >= 0.5 * 0.1 / 8 && shortest < 0.1 / 8 + 1e-14);
    verify("  none is longer than the longest",
           longest > 0.15 && longest < 0.2 + 1e-14);
  }



  /// Steps of dy/dt = -y by the implicit Euler method from y = 1 to t = 16,
  /// whose errors, of second order, are to be @p tolerance: the largest error,
  /// and the number of steps.
  std::pair<double, unsigned int>
  follow_decay(const double tolerance)
  {
    TimeSteps steps({16.}, 1024, 6, StepControl::accurate, {});
    double    y = 1, largest = 0;
    while (!steps.finished())
      {
        const double length = steps.next_time() - steps.time();
        y /= 1. + length;
        steps.advance(1, 0.5 * length * length * y / tolerance);
        largest = std::max(largest, std::abs(y - std::exp(-steps.time())));
      }
    return {largest, steps.number() - 1};
  }



  void
  check_errors()
  {
    output() << "Accurate steps" << std::endl;
    const auto [fine, many]  = follow_decay(1e-4);
    const auto [coarse, few] = follow_decay(1e-3);
    verify("  grow where things become slow", many < 200);
    verify("  a tenth of the error, about three times as many",
           many > 2.2 * few && many < 3.8 * few);
    // Steps l = sqrt(2 tolerance / y) give e' = -e + tolerance / l, whose
    // largest value is sqrt(tolerance / 8).
    verify("  and the error is that of these steps",
           std::abs(fine / std::sqrt(1e-4 / 8.) - 1.) < 0.2 &&
             std::abs(coarse / std::sqrt(1e-3 / 8.) - 1.) < 0.2);
  }



  /// The last step has ended at 10, and the checkpoint is from before it was
  /// counted; a longer history with another stop goes on from there.
  void
  check_longer_history()
  {
    TimeSteps steps({10.}, 10, 2, StepControl::adaptive, {});
    while (steps.next_time() < 10.)
      steps.advance(4);
    TimeSteps longer = copy_from_checkpoint(
      steps, TimeSteps({20.}, 20, 2, StepControl::adaptive, {9.9, 10.5}));
    output() << "A longer history" << std::endl;
    verify("  other stops would move the end", longer.next_time() == 9.9);
    longer.end_step_at(10.);
    longer.advance(6);
    verify("  the step that has been taken ends where it did",
           longer.time() == 10.);
    verify("  and the next at the next stop", longer.next_time() == 10.5);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const TimeSteps eight({8.}, 8, 2, StepControl::adaptive, {});
  print_steps("As many iterations as wanted", eight, Attempts(8, 6));
  print_steps("Easy: longer, to the longest", eight, {2, 2, 2, 2, 2});
  print_steps("Hard: shorter, to the shortest", eight, {12, 100, 24, 24, 6});
  print_steps("Cuts", eight, {0, 6, 0, 4, 0, 0, 0, 6});
  print_steps("What is left is divided",
              TimeSteps({8.}, 8, 2, StepControl::adaptive, {2.5, 4., 9.}),
              Attempts(9, 6));
  print_steps("Segments begin with their own steps",
              TimeSteps({2., 12.}, 12, 2, StepControl::adaptive, {}),
              {24, 24, 1, 1, 1, 6, 6, 6, 6, 6});
  check_random_histories();
  check_errors();
  check_longer_history();
}
