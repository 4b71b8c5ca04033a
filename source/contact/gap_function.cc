// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>

#include "contact/gap_function.h"
#include "contact/indenter_library.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();



    template <int n_coordinates>
    Point<n_coordinates>
    to_point(const std::vector<double> &coordinates)
    {
      Point<n_coordinates> point;
      for (unsigned int d = 0; d < coordinates.size(); ++d)
        point[d] = coordinates[d];
      return point;
    }
  } // namespace



  template <int dim>
  GapFunction<dim>::GapFunction(const IndenterParameters &parameters,
                                const double              surface_height)
    : indenter(make_indenter<dim>(parameters))
    , indenter_position(to_point<dim - 1>(parameters.position))
    , reach(parameters.reach > 0 ? parameters.reach : infinity)
    , tip_height(surface_height + parameters.initial_gap)
  {}



  template <int dim>
  bool
  GapFunction<dim>::has_indenter() const
  {
    return indenter != nullptr;
  }



  template <int dim>
  const Point<dim - 1> &
  GapFunction<dim>::position() const
  {
    return indenter_position;
  }



  template <int dim>
  double
  GapFunction<dim>::value(const Point<dim> &p) const
  {
    Point<dim - 1> offset;
    for (unsigned int d = 0; d < dim - 1; ++d)
      offset[d] = p[d] - indenter_position[d];

    if (!has_indenter() || !within(offset.norm(), reach))
      return infinity;
    return indenter->profile(offset) + tip_height - p[dim - 1];
  }



  template class GapFunction<2>;
  template class GapFunction<3>;
} // namespace ElastoPlastic
