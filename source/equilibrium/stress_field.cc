// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/tensors.h"
#include "equilibrium/johnson_mercier.h"
#include "equilibrium/stress_field.h"

namespace ElastoPlastic
{
  SymmetricTensor<2, 3>
  StressField::at(const unsigned int triangle,
                  const unsigned int subtriangle,
                  const unsigned int corner) const
  {
    return in_space<2>(JohnsonMercier::stress_at(in_plane[triangle],
                                                 subtriangle,
                                                 corner),
                       out_of_plane[triangle][3 * subtriangle + corner]);
  }



  SymmetricTensor<2, 3>
  StressField::without_weight(const PlaneBody   &body,
                              const unsigned int triangle,
                              const unsigned int subtriangle,
                              const unsigned int corner) const
  {
    const auto corners = JohnsonMercier::subtriangle_of(
      body.mesh.corners(body.mesh.triangles[triangle]), subtriangle);
    const auto pressure =
      body.pressure_of_body_force(corners[corner], load_factor) *
      unit_symmetric_tensor<3>();
    if (!body.is_on_axis(corners[corner]))
      return at(triangle, subtriangle, corner) / body.weight(corners[corner]) -
             pressure;
    const unsigned int a = (corner + 1) % 3, b = (corner + 2) % 3;
    return (at(triangle, subtriangle, a) + at(triangle, subtriangle, b)) /
             (body.weight(corners[a]) + body.weight(corners[b])) -
           pressure;
  }



  double
  StressField::max_pressure() const
  {
    double largest = 0;
    for (const auto &of_side : pressure)
      largest = std::max({largest, of_side[0], of_side[1]});
    return largest;
  }



  // An interior point leaves a little pressure everywhere. From the end that is
  // pressed to one that is not, the pressure is linear; so half of such a side
  // counts.
  double
  StressField::contact_area(const PlaneBody &body) const
  {
    const double threshold = 1e-4 * max_pressure();
    double       area      = 0;
    for (unsigned int s = 0; s < pressure.size(); ++s)
      for (unsigned int end = 0; end < 2; ++end)
        if (pressure[s][end] > threshold)
          {
            const SplitMesh::Side &side = body.mesh.sides[s];
            const Point<2> here  = body.mesh.vertices[side.vertices[end]],
                           there = body.mesh.vertices[side.vertices[1 - end]];
            area += body.angle() *
                    body.weight(Point<2>(0.75 * here + 0.25 * there)) * 0.5 *
                    body.mesh.length(side);
          }
    return area;
  }
} // namespace ElastoPlastic
