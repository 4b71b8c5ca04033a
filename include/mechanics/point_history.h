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
  class PointHistory
  {
  public:
    using Number = Simd<double>;

    explicit PointHistory(const unsigned int n_back_stresses)
      : n_back_stresses(n_back_stresses)
      , n_state_values(MaterialState<Number>::n_values(n_back_stresses))
    {}

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
      if (!batches[batch].empty())
        result.unpack(&batches[batch][n_state_values * point]);
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
      state.pack(&batches[batch][n_state_values * point]);
    }

    /// The states at the points of one cell, one after the other.
    std::vector<double>
    cell_values(const unsigned int batch, const unsigned int lane) const
    {
      std::vector<double> values(n_points_per_cell * n_state_values, 0.);
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
      for (unsigned int i = 0; i < values.size(); ++i)
        batches[batch][i][lane] = values[i];
    }

  private:
    void
    make_room(const unsigned int batch)
    {
      if (batches[batch].empty())
        batches[batch].resize(n_points_per_cell * n_state_values, Number(0.));
    }

    const unsigned int n_back_stresses;
    const unsigned int n_state_values;

    unsigned int                       n_points_per_cell = 0;
    std::vector<AlignedVector<Number>> batches;
  };
} // namespace ElastoPlastic

#endif
