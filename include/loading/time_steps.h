// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loading_time_steps_h
#define loading_time_steps_h

#include <cstdint>
#include <vector>

namespace ElastoPlastic
{
  /// The load steps of a history: which one comes next, cutting a step that
  /// fails, growing again after success. No step crosses the end of a segment.
  ///
  /// In each segment there is a number of equal steps. A cut halves the step
  /// under way; a shorter step is doubled again after it has succeeded, as soon
  /// as the doubled one ends where an uncut one would. The position in an uncut
  /// step is counted in units of the shortest possible one, so that times do
  /// not depend on rounding.
  class TimeSteps
  {
  public:
    /// @p segment_ends are the ends of the segments, increasing; the first
    /// begins at 0. @p n_steps is their total number of steps, which the
    /// segments share in proportion to their lengths (at least one each).
    TimeSteps(const std::vector<double> &segment_ends,
              const unsigned int         n_steps,
              const unsigned int         max_cuts);

    /// Whether the end of the last segment has been reached.
    bool
    finished() const;

    /// The number of the step under way: 1 for the first.
    unsigned int
    number() const;

    /// The end of the last step that has succeeded.
    double
    time() const;

    /// The end of the step under way; after the last one, the end of all.
    double
    next_time() const;

    /// The ends of all steps as long as none is cut, increasing.
    const std::vector<double> &
    uncut_ends() const;

    /// The step under way has succeeded: on to the next.
    void
    advance();

    /// The step under way has failed: try half of it. @return false if it is
    /// as short as it may be.
    bool
    cut();

    /// The position in the history, for checkpoints. It may be taken over by
    /// another history with the same steps until then.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &step_number &n_uncut &position &length;
    }

  private:
    /// In the uncut step under way.
    double
    time_at(const std::uint64_t units) const;

    std::vector<double> ends;
    /// Of an uncut step.
    const std::uint64_t units_per_step;

    unsigned int step_number = 1;
    /// The uncut steps behind us, and the position in the next.
    std::uint64_t n_uncut  = 0;
    std::uint64_t position = 0;
    std::uint64_t length;
  };
} // namespace ElastoPlastic

#endif
