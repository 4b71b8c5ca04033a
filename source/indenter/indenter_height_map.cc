// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "indenter/indenter_height_map.h"

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
    Tensor<1, dim - 1>
    distance_of_pixels(const Table<2, double>    &heights,
                       const std::vector<double> &size)
    {
      AssertDimension(size.size(), dim - 1);
      Tensor<1, dim - 1> spacing;
      spacing[dim - 2] = size[dim - 2] / (heights.n_rows() - 1.);
      spacing[0]       = size[0] / (heights.n_cols() - 1.);
      return spacing;
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
    , spacing(distance_of_pixels<dim>(heights, size))
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



  // The only second derivative of a bilinear function is the mixed one, here of
  // the heights at the four corners of a pixel.
  template <int dim>
  IndenterSurface<dim>
  IndenterHeightMap<dim>::surface(const Point<dim - 1> &x) const
  {
    IndenterSurface<dim> result{profile(x), {}, {}};
    if (std::isinf(result.height))
      return result;
    result.slope = interpolation.gradient(x);
    if (dim == 3)
      {
        Point<dim - 1> corner;
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            const double n = std::round(size[d] / spacing[d]);
            const double i = std::floor((x[d] + size[d] / 2) / spacing[d]);
            corner[d] = std::clamp(i, 0., n - 1) * spacing[d] - size[d] / 2;
          }
        Point<dim - 1> right = corner, upper = corner;
        right[0] += spacing[0];
        upper[dim - 2] += spacing[dim - 2];
        result.curvature[0][dim - 2] =
          (interpolation.value(corner + spacing) - interpolation.value(right) -
           interpolation.value(upper) + interpolation.value(corner)) /
          (spacing[0] * spacing[dim - 2]);
      }
    return result;
  }



  template <int dim>
  IndenterSurface<dim>
  IndenterHeightMap<dim>::surface_for(const Point<dim - 1> & /*origin*/,
                                      const Point<dim - 1> &x,
                                      const double /* body_size */) const
  {
    if (std::isinf(profile(x)))
      return {profile(x), {}, {}};
    Point<dim - 1> from_first_pixel;
    for (unsigned int d = 0; d < dim - 1; ++d)
      from_first_pixel[d] = std::clamp(x[d] + size[d] / 2, 0., size[d]);
    return smooth_surface<dim>(interpolation.get_data(),
                               spacing,
                               from_first_pixel);
  }



  template class IndenterHeightMap<2>;
  template class IndenterHeightMap<3>;
} // namespace ElastoPlastic
