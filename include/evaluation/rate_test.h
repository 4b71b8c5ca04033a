// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_rate_test_h
#define evaluation_rate_test_h

#include <optional>
#include <utility>
#include <vector>

#include "evaluation/indentation_test.h"

namespace ElastoPlastic
{
  /// How the hardness H = force / contact area depends on the rate r = (dh/dt)
  /// / h of the depth h, by a segment of the load history.
  struct RateSensitivity
  {
    /// Its end.
    IndentationPoint end;
    /// By how much the depth has grown in a hold, else not a number.
    double creep_depth;
    /// d ln H / d ln r of the hold, and from the segment before to this one;
    /// the one that is not found is not a number.
    double of_hold, of_jump;

    /// As a row of indentation.csv, without an unloading; for @p modelled_part
    /// see IndentationTest.
    UnloadingResult
    row(const double modelled_part) const;
  };



  /// Watches the segments of a load history, step by step, for what they say of
  /// the rate sensitivity m = d ln H / d ln r @cite lucas_oliver_1999.
  ///
  /// A hold in which the depth grows by steps, three at least: the line of
  /// least squares through their ln H over ln r, of which those in the first
  /// tenth of the hold are left out, because stresses of the loading relax
  /// there. A jump, where a segment with a growing depth follows another one,
  /// without holds: from the last steps of both, if the rate then differs by
  /// the factor least_jump at least. (Implicit steps: the hardness at the end
  /// of a step belongs to the mean rate in it.)
  class RateTest
  {
  public:
    static constexpr double first_part = 0.1;
    static constexpr double least_jump = 1.2;

    /// @param segment_ends increasing; @param holds begin and end of those
    /// segments in which the load does not change.
    RateTest(const std::vector<double>                    &segment_ends,
             const std::vector<std::pair<double, double>> &holds)
      : segment_ends(segment_ends)
      , holds(holds)
    {}


    /// Adds the end of the next step. @return what a segment that ends there
    /// says, if anything.
    std::optional<RateSensitivity>
    add(const IndentationPoint &point);

    /// The mesh has changed: the end of the last step, @p before, is @p after
    /// on the new one.
    void
    change_mesh(const IndentationPoint &before, const IndentationPoint &after);

    /// The end of a step.
    struct Step
    {
      double time = 0;
      /// The mean one of the step.
      double rate     = 0;
      double hardness = 0;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /* version */)
      {
        archive &time &rate &hardness;
      }
    };

    /// What this object remembers.
    struct Progress
    {
      /// The end of the last step; and where the segment under way began, as if
      /// the mesh had not changed since then.
      IndentationPoint last, begin;
      /// The steps since then in which the depth has grown; and the last step
      /// of the segment before, without a rate if that was a hold or the depth
      /// did not grow.
      std::vector<Step> steps;
      Step              before;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /* version */)
      {
        archive &last &begin &steps &before;
      }
    };

    /// For checkpoints.
    const Progress &
    progress() const
    {
      return memory;
    }

    void
    resume(const Progress &progress)
    {
      memory = progress;
    }

  private:
    /// The time at which the hold begins that ends at @p time.
    std::optional<double>
    begin_of_hold(const double time) const;

    std::vector<double>                    segment_ends;
    std::vector<std::pair<double, double>> holds;

    Progress memory;
  };
} // namespace ElastoPlastic

#endif
