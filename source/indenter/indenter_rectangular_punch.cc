// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "indenter/indenter_rectangular_punch.h"

namespace ElastoPlastic
{
  template <int dim>
  IndenterRectangularPunch<dim>::IndenterRectangularPunch(
    const std::vector<double> &half_widths)
  {
    AssertDimension(half_widths.size(), dim - 1);
    std::copy_n(half_widths.begin(), dim - 1, widths.begin());
  }



  template <int dim>
  double
  IndenterRectangularPunch<dim>::profile(const Point<dim - 1> &x) const
  {
    for (unsigned int d = 0; d < dim - 1; ++d)
      if (!within(std::abs(x[d]), widths[d]))
        return std::numeric_limits<double>::infinity();
    return 0;
  }



  template <int dim>
  IndenterSurface<dim>
  IndenterRectangularPunch<dim>::surface(const Point<dim - 1> &x) const
  {
    return {profile(x), {}, {}};
  }



  template <int dim>
  bool
  IndenterRectangularPunch<dim>::is_convex() const
  {
    return true;
  }



  template <int dim>
  std::optional<std::array<double, dim - 1>>
  IndenterRectangularPunch<dim>::half_widths() const
  {
    return widths;
  }



  template <int dim>
  double
  IndenterRectangularPunch<dim>::depth_factor() const
  {
    return 1.;
  }



  template class IndenterRectangularPunch<2>;
  template class IndenterRectangularPunch<3>;
} // namespace ElastoPlastic
