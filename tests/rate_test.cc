// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The rate sensitivity of a hardness H = c r^m, with the rate r = (dh/dt) / h,
// from a hold and from jumps of the rate; on a mesh that changes on the way;
// and what says nothing.

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>
#include <boost/serialization/vector.hpp>

#include <cmath>
#include <sstream>

#include "evaluation/rate_test.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  const double m = 0.2;

  /// Of a cone, with the rate of a step of this @p duration.
  IndentationPoint
  next_point(const IndentationPoint &last,
             const double            time,
             const double            depth)
  {
    const double rate = std::log(depth / last.depth) / (time - last.time);
    const double area = 25. * depth * depth;
    return {last.step + 1, time, depth, 300. * std::pow(rate, m) * area, area};
  }



  /// In the middle of a history, with what a checkpoint keeps.
  RateTest
  after_checkpoint(const RateTest &test, RateTest other)
  {
    std::stringstream             state;
    const RateTest::Progress      progress = test.progress();
    boost::archive::text_oarchive out(state);
    out << progress;
    boost::archive::text_iarchive in(state);
    RateTest::Progress            copy;
    in >> copy;
    other.resume(copy);
    return other;
  }



  /// What a segment says; in a hold, the depth has grown by @p growth.
  void
  report(const std::string     &title,
         const RateSensitivity &result,
         const double           growth)
  {
    output() << title << ", t = " << result.end.time << std::endl;
    if (std::isfinite(result.creep_depth))
      verify("  creep", std::abs(result.creep_depth / growth - 1.), 1e-10);
    if (std::isfinite(result.of_hold))
      verify("  of the hold", std::abs(result.of_hold - m), 1e-12);
    if (std::isfinite(result.of_jump))
      verify("  of the jump", std::abs(result.of_jump - m), 1e-12);
    verify("  no unloading",
           std::isnan(result.row(0.25).stiffness) &&
             result.row(0.25).modelled_part == 0.25);
  }



  /// Depth exp(rate t) in three segments, the second ten times as fast; then a
  /// hold, in which the rate falls by and by. At the beginning of the hold, the
  /// hardness is another one.
  void
  check_history(const bool mesh_changes)
  {
    const std::vector<double> ends = {1., 2., 3., 4., 5.};
    RateTest                  test(ends, {{3., 4.}});
    IndentationPoint          last   = {0, 0., 0.01, 0., 0.};
    double                    growth = 0.;
    for (unsigned int i = 1; i <= 50; ++i)
      {
        const double     time = i / 10.;
        const double     rate = i <= 10 || i > 40 ? 0.05 :
                                i <= 20           ? 0.5 :
                                i <= 30           ? 0.05 :
                                                    0.5 / (i - 30);
        IndentationPoint point =
          next_point(last, time, last.depth * std::exp(rate * 0.1));
        if (i == 31)
          point.force *= 2.;
        if (i > 30)
          growth += point.depth - last.depth;
        if (const auto result = test.add(point))
          report(mesh_changes ? "Meshes" : "A mesh", *result, growth);
        last = point;
        if (i % 7 == 0)
          test = after_checkpoint(test, RateTest(ends, {{3., 4.}}));
        if (mesh_changes && i % 3 == 0)
          {
            last.depth *= 1.01;
            test.change_mesh(point, last);
          }
      }
  }



  void
  check_silence()
  {
    RateTest test({1., 2., 3., 4., 5.}, {{1., 2.}, {4., 5.}});
    bool     is_silent = !test.add({1, 1., 0.1, 5., 0.2});
    is_silent &= !test.add({2, 2., 0.1, 4., 0.2}); // relaxation
    is_silent &= !test.add({3, 3., 0.05, 0., 0.}); // unloading
    verify("Nothing of one step, a constant depth, an unloading", is_silent);
    bool is_held = !test.add({4, 4., 0.1, 4., 0.2});
    for (unsigned int i = 1; i <= 4; ++i)
      is_held &= !test.add(
        {4 + i, 4. + 0.25 * i, 0.1 * (1. + 4e-16 * i), 4. - 0.1 * i, 0.2});
    verify("Nothing of a depth that grows by rounding errors", is_held);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_history(false);
  check_history(true);
  check_silence();
}
