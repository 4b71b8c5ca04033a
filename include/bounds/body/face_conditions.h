// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_face_conditions_h
#define bounds_body_face_conditions_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bounds/body/split_body.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// The point @p x of a side or face, moved towards its @p centre by little
  /// more than rounding. A load that jumps at a vertex has one value there for
  /// all sides that meet: what it is on one of them is found inside it.
  template <int dim>
  Point<dim>
  from_inside(const Point<dim> &x, const Point<dim> &centre)
  {
    constexpr double rounding = 64. * std::numeric_limits<double>::epsilon();

    const double distance = x.distance(centre);
    if (distance == 0.)
      return x;
    double coordinate = 0;
    for (unsigned int d = 0; d < dim; ++d)
      coordinate = std::max(coordinate, std::abs(x[d]));
    const double share = std::clamp(rounding * coordinate / distance,
                                    Tolerance::smallest_inset,
                                    Tolerance::largest_inset);
    return Point<dim>(x + share * (centre - x));
  }



  /// The conditions of the faces of a @p mesh, from those of the boundaries;
  /// see make_split_body(). @throws InputError
  template <int dim>
  std::vector<FaceCondition<dim>>
  conditions_of_faces(const SplitMesh<dim>          &mesh,
                      const BoundaryConditions<dim> &conditions,
                      const IndenterOnBody<dim>     &indenter,
                      const Loads<dim>              &loads);
} // namespace ElastoPlastic

#endif
