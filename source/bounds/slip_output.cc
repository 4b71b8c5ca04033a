// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "bounds/conic/tolerances.h"
#include "bounds/equilibrium_output.h"
#include "bounds/mechanism/face_view.h"
#include "output/patches.h"

namespace ElastoPlastic
{
  SlipOutput::SlipOutput(const OutputParameters &parameters)
    : series(parameters, "slip_lines")
  {}



  // A patch has the points of a polynomial of the degree of the slip, in their
  // order on a side. On the axis, nothing slides.
  template <int dim>
  void
  SlipOutput::write(const SplitBody<dim>                    &body,
                    const std::vector<SimplexVelocity<dim>> &velocity,
                    const unsigned int                       cycle)
  {
    const double threshold =
      Tolerance::smallest_slip * largest_velocity(body, velocity);
    const auto           &points = Bernstein<dim - 1>::points(slip_degree<dim>);
    Patches<dim - 1, dim> patches({{"slip", 3}});
    for (const auto &view : views_of_faces(body))
      {
        if (!view.resists_slip())
          continue;
        DataOutBase::Patch<dim - 1, dim> patch;
        patch.reference_cell = ReferenceCells::get_simplex<dim - 1>();
        patch.n_subdivisions = slip_degree<dim>;
        for (unsigned int i = 0; i < dim; ++i)
          patch.vertices[i] = view.corners[i];
        patch.data.reinit(3, points.size());
        double largest = 0;
        for (unsigned int p = 0; p < points.size(); ++p)
          {
            const Point<dim> x = interpolate(points[p], view.corners);
            if (body.is_on_axis(x))
              continue;
            const Tensor<1, dim> slip =
              view.along(view.jump(velocity, points[p])) / body.weight(x);
            for (unsigned int d = 0; d < dim; ++d)
              patch.data(d, p) = slip[d];
            largest = std::max(largest, slip.norm());
          }
        if (largest > threshold)
          patches.add(patch);
      }
    series.write(patches, cycle);
  }



  template void
  SlipOutput::write(const SplitBody<2> &,
                    const std::vector<SimplexVelocity<2>> &,
                    const unsigned int);
  template void
  SlipOutput::write(const SplitBody<3> &,
                    const std::vector<SimplexVelocity<3>> &,
                    const unsigned int);
} // namespace ElastoPlastic
