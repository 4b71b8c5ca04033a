// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef loading_load_program_h
#define loading_load_program_h

#include <boost/serialization/map.hpp>
#include <boost/serialization/utility.hpp>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/expression.h"
#include "loading/indenter_path.h"
#include "loading/loading_parameters.h"

namespace ElastoPlastic
{
  /// The load over time: segments one after the other, each with one control,
  /// from t = 0 on. In a segment the load is an expression in t, or begins with
  /// the value that has been reached and leads linearly to the one given for
  /// its end, or changes at a constant rate, or grows by a constant part of
  /// itself per time. And the sideways motion that goes with it.
  class LoadProgram
  {
  public:
    /// @throws InputError for an expression that cannot be evaluated, a table
    /// that is malformed, not increasing in time or empty, a value that is not
    /// allowed.
    explicit LoadProgram(const LoadingParameters &parameters);

    double
    final_time() const
    {
      return segments.back().end_time;
    }

    /// How the indenter moves sideways meanwhile.
    const IndenterPath &
    path() const
    {
      return indenter_path;
    }

    /// The ends of the segments, and the corners of the path between them,
    /// increasing; the last is final_time().
    std::vector<double>
    segment_ends() const;

    bool
    is_segment_end(const double time) const;

    /// How many times as fast as before the indenter goes on after @p time,
    /// which is a segment's end. None where it turns or stops, or its control
    /// changes, for one that moves sideways, and at the end of the history.
    std::optional<double>
    change_of_pace(const double time) const;

    /// Whether load and path turn at segment_ends() only.
    bool
    turns_at_segment_ends_only() const;

    /// The load at @p time > 0, at a segment's end that of the segment that
    /// ends. None as long as it depends on what will be reached before: where
    /// the control changes, in the interior of the segment that follows, and at
    /// given rates until the next one that leads to a given value.
    /// @throws InputError for a load that is not allowed: a negative force, a
    /// strain rate without a depth.
    std::optional<Load>
    load(const double time) const;

    /// Begin and end of the segments of a table in which the load does not
    /// change.
    std::vector<std::pair<double, double>>
    holds() const;

    /// Tells what has been reached at @p time. If a segment ends then, and the
    /// next one has another control, it starts from there.
    void
    reached(const double time, const double depth, const double force);

    /// What has been reached, for checkpoints. It may be taken over by another
    /// history with the same segments until then.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /* version */)
    {
      archive &turning_points;
    }

  private:
    enum class Ramp
    {
      to_value,      ///< linear, to a given value
      at_rate,       ///< so much per time
      at_strain_rate ///< such a part of itself per time
    };

    struct Segment
    {
      double  end_time;
      Control control;
      Ramp    ramp;
      /// The value at the end, or the rate.
      double number = 0;
      /// Where it comes from.
      std::string row = "";
      /// Instead of the ramp, if there is one.
      std::shared_ptr<const Expression<1>> expression = nullptr;
      /// What is not larger than that of the expression is a rounding error of
      /// zero.
      double rounding = 0.;
    };

    void
    read_history(const std::string &table);

    /// @throws InputError
    Segment
    read_row(const std::string &row) const;

    void
    read_expression(const LoadingParameters &parameters);

    /// The time at which a segment begins.
    double
    begin_time(const unsigned int segment) const
    {
      return segment == 0 ? 0. : segments[segment - 1].end_time;
    }

    /// The load there, and at @p time in the segment; none as long as it
    /// depends on what will be reached. @throws InputError
    std::optional<double>
    begin_value(const unsigned int segment) const;

    std::optional<double>
    value(const unsigned int segment, const double time) const;

    /// How fast the load changes at @p time in a segment without expression;
    /// none as long as that depends on what will be reached.
    /// @throws InputError
    std::optional<double>
    rate(const unsigned int segment, const double time) const;

    std::vector<Segment> segments;
    IndenterPath         indenter_path;

    /// Depth and force that have been reached at the ends of segments.
    std::map<double, std::pair<double, double>> turning_points;
  };
} // namespace ElastoPlastic

#endif
