// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>

#include "contact/gap_function.h"

namespace ElastoPlastic
{
  template <int dim>
  GapFunction<dim>::GapFunction(const PlacedIndenter<dim> &indenter,
                                const double               surface_height)
    : indenter(indenter)
    , tip_height(surface_height + indenter.initial_gap)
  {}



  template <int dim>
  bool
  GapFunction<dim>::has_indenter() const
  {
    return indenter.shape != nullptr;
  }



  template <int dim>
  const Point<dim - 1> &
  GapFunction<dim>::position() const
  {
    return indenter.position;
  }



  template <int dim>
  double
  GapFunction<dim>::value(const Point<dim> &p) const
  {
    Point<dim - 1> offset;
    for (unsigned int d = 0; d < dim - 1; ++d)
      offset[d] = p[d] - indenter.position[d];

    if (!has_indenter() || !within(offset.norm(), indenter.reach))
      return std::numeric_limits<double>::infinity();
    return indenter.shape->profile(offset) + tip_height - p[dim - 1];
  }



  template class GapFunction<2>;
  template class GapFunction<3>;
} // namespace ElastoPlastic
