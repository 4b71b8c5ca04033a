// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/indenter_height_map.h"

namespace ElastoPlastic
{
  namespace
  {
    /// From rows and columns, top row first, to indices along x (and y); the
    /// lowest value becomes zero.
    template <int dim>
    Table<dim - 1, double>
    scaled_by_coordinates(const Table<2, double> &heights, const double scale)
    {
      double lowest = std::numeric_limits<double>::max();
      for (unsigned int row = 0; row < heights.n_rows(); ++row)
        for (unsigned int column = 0; column < heights.n_cols(); ++column)
          lowest = std::min(lowest, scale * heights(row, column));

      TableIndices<dim - 1> index;
      index[dim - 2] = heights.n_rows();
      index[0]       = heights.n_cols();
      Table<dim - 1, double> table;
      table.reinit(index);
      for (unsigned int row = 0; row < heights.n_rows(); ++row)
        for (unsigned int column = 0; column < heights.n_cols(); ++column)
          {
            index[dim - 2] = heights.n_rows() - 1 - row;
            index[0]       = column;
            table(index)   = scale * heights(row, column) - lowest;
          }
      return table;
    }



    template <int dim>
    Functions::InterpolatedUniformGridData<dim - 1>
    interpolate(const Table<2, double>    &heights,
                const double               scale,
                const std::vector<double> &size)
    {
      AssertDimension(size.size(), dim - 1);
      Assert(dim == 3 || heights.n_rows() == 1, ExcInternalError());
      Table<dim - 1, double> table = scaled_by_coordinates<dim>(heights, scale);

      std::array<std::pair<double, double>, dim - 1> ends;
      std::array<unsigned int, dim - 1>              n_subintervals;
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          ends[d]           = {-size[d] / 2, size[d] / 2};
          n_subintervals[d] = table.size(d) - 1;
        }
      return {std::move(ends), std::move(n_subintervals), std::move(table)};
    }
  } // namespace



  template <int dim>
  IndenterHeightMap<dim>::IndenterHeightMap(const Table<2, double>    &heights,
                                            const double               scale,
                                            const std::vector<double> &size)
    : size(size)
    , pixel(dim == 2 ? size[0] / (heights.n_cols() - 1.) :
                       std::max(size[0] / (heights.n_cols() - 1.),
                                size.back() / (heights.n_rows() - 1.)))
    , interpolation(interpolate<dim>(heights, scale, size))
  {}



  template <int dim>
  double
  IndenterHeightMap<dim>::profile(const Point<dim - 1> &x) const
  {
    for (unsigned int d = 0; d < dim - 1; ++d)
      if (!within(std::abs(x[d]), size[d] / 2))
        return std::numeric_limits<double>::infinity();
    return interpolation.value(x);
  }



  template <int dim>
  double
  IndenterHeightMap<dim>::detail() const
  {
    return pixel;
  }



  template <int dim>
  double
  IndenterHeightMap<dim>::section_area(const double) const
  {
    return 0.;
  }



  template class IndenterHeightMap<2>;
  template class IndenterHeightMap<3>;
} // namespace ElastoPlastic
