// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/gap_function.h"

namespace ElastoPlastic
{
  template <int dim>
  double
  GapFunction<dim>::value(const Point<dim> &p) const
  {
    const Point<dim - 1> x = offset(p);
    return reaches(x) ? indenter.shape->profile(x) + tip_height - p[dim - 1] :
                        std::numeric_limits<double>::infinity();
  }



  template <int dim>
  Footprint<dim - 1>
  GapFunction<dim>::footprint() const
  {
    Footprint<dim - 1> result;
    if (!has_indenter())
      return result;
    const auto radius      = indenter.shape->disc_radius();
    const auto half_widths = indenter.shape->half_widths();
    if (half_widths)
      result.rectangle = {present_position, *half_widths};
    if (radius || half_widths)
      if (const double smallest =
            std::min(radius.value_or(indenter.reach), indenter.reach);
          !std::isinf(smallest))
        result.disc = {present_position, smallest};
    return result;
  }



  template <int dim>
  IndenterSurface<dim>
  GapFunction<dim>::surface_for(const Point<dim> &origin,
                                const Point<dim> &p) const
  {
    const Point<dim - 1> x = offset(p);
    if (!reaches(x))
      return {std::numeric_limits<double>::infinity(), {}, {}};
    IndenterSurface<dim> result =
      indenter.shape->surface_for(offset(origin), x, body_size);
    result.height += tip_height - p[dim - 1];
    return result;
  }



  template <int dim>
  Point<dim - 1>
  GapFunction<dim>::offset(const Point<dim> &p) const
  {
    Point<dim - 1> x;
    for (unsigned int d = 0; d < dim - 1; ++d)
      x[d] = p[d] - present_position[d];
    return x;
  }



  template class GapFunction<2>;
  template class GapFunction<3>;
} // namespace ElastoPlastic
