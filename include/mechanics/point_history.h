// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_point_history_h
#define mechanics_point_history_h

#include <deal.II/base/aligned_vector.h>

#include <algorithm>
#include <vector>

#include "material/material_state.h"

namespace ElastoPlastic
{
  /// What the material points of all cell batches remember, in the layout of
  /// the batches. Those of which all points are virgin take no memory.
  ///
  /// Points that keep increments also remember by how much the last load step
  /// has changed them. Then a step may begin with states that go on by a part
  /// of that (extrapolate()).
  class PointHistory
  {
  public:
    using Number = Simd<double>;

    explicit PointHistory(const unsigned int n_back_stresses)
      : n_back_stresses(n_back_stresses)
      , n_state_values(MaterialState<Number>::n_values(n_back_stresses))
      , n_point_values(n_state_values)
    {}

    /// From the next reinit() on.
    void
    keep_increments()
    {
      n_point_values = 2 * n_state_values;
    }

    bool
    keeps_increments() const
    {
      return n_point_values > n_state_values;
    }

    /// Lets state() be the last states and @p weight times their increments.
    /// Other than 0 only where these are kept.
    void
    extrapolate(const double weight)
    {
      Assert(weight == 0. || keeps_increments(), ExcInternalError());
      extrapolation = weight;
    }

    /// The weight.
    double
    extrapolation_weight() const
    {
      return extrapolation;
    }

    /// All points become virgin.
    void
    reinit(const unsigned int n_cell_batches, const unsigned int n_points)
    {
      n_points_per_cell = n_points;
      batches           = std::vector<AlignedVector<Number>>(n_cell_batches);
    }

    /// The number of points of a cell.
    unsigned int
    n_points() const
    {
      return n_points_per_cell;
    }

    MaterialState<Number>
    state(const unsigned int batch, const unsigned int point) const
    {
      MaterialState<Number> result(n_back_stresses);
      if (batches[batch].empty())
        return result;
      const Number *values = &batches[batch][n_point_values * point];
      if (extrapolation == 0.)
        {
          result.unpack(values);
          return result;
        }
      result.unpack(extrapolated(values).data());
      return result;
    }

    void
    set_state(const unsigned int           batch,
              const unsigned int           point,
              const MaterialState<Number> &state)
    {
      if (batches[batch].empty() && state.is_virgin())
        return;
      make_room(batch);
      state.pack(&batches[batch][n_point_values * point]);
    }

    /// Sets the state at the end of a load step. The increment, if it is kept,
    /// is that from the last state, or zero if the state is that with which the
    /// step has begun: then nothing has flowed.
    void
    end_step(const unsigned int           batch,
             const unsigned int           point,
             const MaterialState<Number> &state)
    {
      if (!keeps_increments())
        return set_state(batch, point, state);
      if (batches[batch].empty() && state.is_virgin())
        return;
      make_room(batch);
      Number           *values = &batches[batch][n_point_values * point];
      const StateValues begun  = extrapolated(values);
      StateValues       before;
      std::copy_n(values, n_state_values, before.begin());
      state.pack(values);
      for (unsigned int lane = 0; lane < Number::size(); ++lane)
        {
          bool has_flowed = false;
          for (unsigned int i = 0; i < n_state_values; ++i)
            has_flowed = has_flowed || values[i][lane] != begun[i][lane];
          for (unsigned int i = 0; i < n_state_values; ++i)
            values[n_state_values + i][lane] =
              has_flowed ? values[i][lane] - before[i][lane] : 0.;
        }
    }

    /// What is kept of the points of one cell, one after the other: its state,
    /// and then the increment if that is kept.
    std::vector<double>
    cell_values(const unsigned int batch, const unsigned int lane) const
    {
      std::vector<double> values(n_points_per_cell * n_point_values, 0.);
      if (!batches[batch].empty())
        for (unsigned int i = 0; i < values.size(); ++i)
          values[i] = batches[batch][i][lane];
      return values;
    }

    void
    set_cell_values(const unsigned int         batch,
                    const unsigned int         lane,
                    const std::vector<double> &values)
    {
      if (batches[batch].empty() &&
          std::all_of(values.begin(), values.end(), [](const double value) {
            return value == 0.;
          }))
        return;
      make_room(batch);
      AssertThrow(values.size() == batches[batch].size(),
                  ExcDimensionMismatch(values.size(), batches[batch].size()));
      for (unsigned int i = 0; i < values.size(); ++i)
        batches[batch][i][lane] = values[i];
    }

  private:
    using StateValues =
      std::array<Number, MaterialState<Number>::n_values(max_back_stresses)>;

    /// The values of a state that goes on from @p values, those of a point.
    StateValues
    extrapolated(const Number *const values) const
    {
      StateValues result;
      for (unsigned int i = 0; i < n_state_values; ++i)
        result[i] =
          values[i] + Number(extrapolation) * values[n_state_values + i];
      return result;
    }

    void
    make_room(const unsigned int batch)
    {
      if (batches[batch].empty())
        batches[batch].resize(n_points_per_cell * n_point_values, Number(0.));
    }

    const unsigned int n_back_stresses;
    const unsigned int n_state_values;
    unsigned int       n_point_values;
    double             extrapolation = 0.;

    unsigned int                       n_points_per_cell = 0;
    std::vector<AlignedVector<Number>> batches;
  };
} // namespace ElastoPlastic

#endif
