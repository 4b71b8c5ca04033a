// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_values_of_simplices_h
#define tests_values_of_simplices_h

#include <functional>
#include <vector>

#include "bounds/mesh/split_mesh.h"

namespace ElastoPlastic
{
  /// By simplices, the volume times the @p density at the centre of gravity.
  template <int dim>
  std::vector<double>
  values_of_simplices(const SplitMesh<dim>                            &mesh,
                      const std::function<double(const Point<dim> &)> &density)
  {
    std::vector<double> values;
    for (const auto &simplex : mesh.simplices)
      {
        const Corners<dim> corners = mesh.corners(simplex);
        Point<dim>         centre;
        for (const auto &corner : corners)
          centre += corner / (dim + 1.);
        values.push_back(volume(corners) * density(centre));
      }
    return values;
  }
} // namespace ElastoPlastic

#endif
