// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loading_time_steps_h
#define loading_time_steps_h

#include <vector>

#include "base/enum_names.h"

namespace ElastoPlastic
{
  enum class StepControl
  {
    fixed,    ///< equal steps, shorter ones only where they fail
    adaptive, ///< as long as the nonlinear solver finds easy
    accurate  ///< as long as their error allows
  };

  template <>
  inline const EnumNames<StepControl> enum_names<StepControl> = {
    {"fixed", StepControl::fixed},
    {"adaptive", StepControl::adaptive},
    {"accurate", StepControl::accurate}};



  /// The load steps of a history: which one comes next, cutting a step that
  /// fails, growing again after success. No step crosses the end of a segment.
  ///
  /// In each segment there is a number of equal, nominal steps; they are the
  /// unit of positions and lengths. A cut halves the step under way.
  ///
  /// Fixed steps: a shorter step is doubled again after it has succeeded, as
  /// soon as the doubled one ends where an uncut one would. (All positions are
  /// binary fractions, so that times do not depend on rounding; but for what
  /// adaptive steps before a checkpoint have left.)
  ///
  /// Adaptive steps: each segment begins with a nominal one; after n Newton
  /// iterations the next is longer by the factor sqrt(target_iterations / n)
  /// @cite ramm_1981, which is kept between 1/2 and 2. What is left up to the
  /// next stop is divided evenly, so that no step is shorter without need.
  ///
  /// Accurate steps: likewise, with the factor sqrt(1 / error), where the error
  /// of the step is measured in the one that is allowed, of second order in its
  /// length.
  class TimeSteps
  {
  public:
    /// So many Newton iterations leave an adaptive step as long as it is.
    static constexpr unsigned int target_iterations = 6;
    /// The longest adaptive and accurate steps: so many nominal ones.
    static constexpr double longest = 2., longest_accurate = 64.;

    /// Fixed steps. @p segment_ends are the ends of the segments, increasing;
    /// the first begins at 0. @p n_steps is their total number of nominal
    /// steps, which the segments share in proportion to their lengths (at least
    /// one each). No step is shorter than one of them after @p max_cuts cuts.
    TimeSteps(const std::vector<double> &segment_ends,
              const unsigned int         n_steps,
              const unsigned int         max_cuts);

    /// Steps with this @p control, not a fixed one, that do not cross the times
    /// @p stops either.
    TimeSteps(const std::vector<double> &segment_ends,
              const unsigned int         n_steps,
              const unsigned int         max_cuts,
              const StepControl          control,
              const std::vector<double> &stops);

    /// Whether the end of the last segment has been reached.
    bool
    finished() const
    {
      return position == ends.size();
    }

    /// The number of the step under way: 1 for the first.
    unsigned int
    number() const
    {
      return step_number;
    }

    /// The end of the last step that has succeeded.
    double
    time() const
    {
      return time_at(position);
    }

    /// The end of the step under way; after the last one, the end of all.
    double
    next_time() const
    {
      return time_at(end());
    }

    /// Whether the step under way is longer than a nominal one.
    bool
    is_longer_than_nominal() const;

    /// The ends of the nominal steps, increasing.
    const std::vector<double> &
    uncut_ends() const
    {
      return ends;
    }

    /// The step under way has succeeded, after @p n_iterations of Newton's
    /// method, with this @p error: on to the next.
    void
    advance(const unsigned int n_iterations = target_iterations,
            const double       error        = 1.);

    /// The step under way has failed: try half of it. @return false if it is
    /// as short as it may be.
    bool
    cut();

    /// Lets the step under way end at @p time, whatever the stops: it has done
    /// so before a checkpoint, in a history with others.
    void
    end_step_at(const double time);

    /// The position in the history, for checkpoints. It may be taken over by
    /// another history with the same nominal steps until then, whatever its
    /// control.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &step_number &position &length;
    }

  private:
    double
    time_at(const double a_position) const;

    double
    position_at(const double time) const;

    /// Of the step under way.
    double
    end() const;

    /// Lets the length of the next step be @p wanted times what this one has
    /// @p taken, or as near to that as steps may change.
    void
    adapt(const double taken, const double wanted);

    /// Times of the nominal steps.
    std::vector<double> ends;

    /// Positions: where segments end, and what no step crosses, increasing.
    StepControl         control;
    std::vector<double> segments;
    std::vector<double> stops;
    double              shortest;

    /// How far the steps have got, and how long the one under way is unless it
    /// is to meet a stop.
    unsigned int step_number = 1;
    double       position    = 0;
    double       length      = 1;
  };
} // namespace ElastoPlastic

#endif
