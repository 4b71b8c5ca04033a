// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_point_history_h
#define mechanics_point_history_h

#include <deal.II/base/aligned_vector.h>

#include <vector>

#include "material/material_state.h"

namespace ElastoPlastic
{
  /// What the material points of all cell batches remember, in the layout of
  /// the batches. As long as all points are virgin, this takes no memory.
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
      n_batches         = n_cell_batches;
      n_points_per_cell = n_points;
      n_cell_values     = n_points * n_state_values;
      numbers.clear();
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
      if (!numbers.empty())
        result.unpack(&numbers[n_cell_values * batch + n_state_values * point]);
      return result;
    }

    void
    set_state(const unsigned int           batch,
              const unsigned int           point,
              const MaterialState<Number> &state)
    {
      make_room();
      state.pack(&numbers[n_cell_values * batch + n_state_values * point]);
    }

    /// The states at the points of one cell, one after the other.
    std::vector<double>
    cell_values(const unsigned int batch, const unsigned int lane) const
    {
      std::vector<double> values(n_cell_values, 0.);
      if (!numbers.empty())
        for (unsigned int i = 0; i < n_cell_values; ++i)
          values[i] = numbers[n_cell_values * batch + i][lane];
      return values;
    }

    void
    set_cell_values(const unsigned int         batch,
                    const unsigned int         lane,
                    const std::vector<double> &values)
    {
      make_room();
      for (unsigned int i = 0; i < n_cell_values; ++i)
        numbers[n_cell_values * batch + i][lane] = values[i];
    }

  private:
    void
    make_room()
    {
      if (numbers.empty())
        numbers.resize(std::size_t(n_cell_values) * n_batches, Number(0.));
    }

    const unsigned int n_back_stresses;
    const unsigned int n_state_values;

    unsigned int                  n_batches         = 0;
    unsigned int                  n_points_per_cell = 0;
    std::size_t                   n_cell_values     = 0;
    dealii::AlignedVector<Number> numbers;
  };
} // namespace ElastoPlastic

#endif
