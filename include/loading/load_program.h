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
#include "loading/load.h"
#include "loading/loading_parameters.h"

namespace ElastoPlastic
{
  /// The load over time: segments one after the other, each with one control,
  /// from t = 0 on. In a segment the load is an expression in t, or linear
  /// between the value reached at its beginning and the one given for its end.
  /// And the sideways motion that goes with it.
  class LoadProgram
  {
  public:
    /// @throws InputError for an expression that cannot be evaluated, a table
    /// that is malformed, not increasing in time or empty, a value that is not
    /// allowed.
    explicit LoadProgram(const LoadingParameters &parameters);

    double
    final_time() const;

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

    /// Whether load and path are linear between segment_ends(), so that they
    /// turn nowhere else.
    bool
    is_piecewise_linear() const;

    /// The load at @p time > 0, at a segment's end that of the segment that
    /// ends. None as long as it depends on what will be reached at the
    /// beginning of its segment: where the control changes, in the interior of
    /// the segment that follows.
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
    struct Segment
    {
      double  end_time;
      Control control;
      double  end_value = 0;
      /// None if it is what has been reached there.
      std::optional<double> begin_value = 0.;
      /// Instead of the two values, if there is one.
      std::shared_ptr<const Expression<1>> expression = nullptr;
      /// What is not larger than that of the expression is a rounding error of
      /// zero.
      double rounding = 0.;
    };

    void
    read_history(const std::string &table);

    void
    read_expression(const LoadingParameters &parameters);

    std::vector<Segment> segments;
    IndenterPath         indenter_path;

    /// Depth and force that have been reached at the ends of segments.
    std::map<double, std::pair<double, double>> turning_points;
  };
} // namespace ElastoPlastic

#endif
