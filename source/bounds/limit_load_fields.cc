// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/limit_load_fields.h"

namespace ElastoPlastic
{
  EquilibriumFields
  fields_of(const PlaneBody &body, const LimitLoad &bounds)
  {
    std::vector<std::array<Tensor<1, 2>, 4>> velocities;
    for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
      velocities.push_back(
        values_at_vertices(body, bounds.velocity.velocity[t], t));
    std::vector<double> work = bounds.velocity.dissipation;
    for (unsigned int t = 0; t < work.size(); ++t)
      work[t] /= body.volume(t);
    return {body, bounds.stress, velocities, bounds.gaps, work};
  }



  const PlaneBody &
  body_of_velocity(const PlaneBody &body, const LimitLoad &)
  {
    return body;
  }



  const SpaceBody &
  body_of_velocity(const SpaceBody &, const SpaceLimitLoad &bounds)
  {
    return bounds.body_of_velocity;
  }



  SpaceFields
  fields_of(const SpaceBody &body, const SpaceLimitLoad &bounds)
  {
    std::vector<std::array<Tensor<1, 3>, 5>> velocities;
    std::vector<double>                      work;
    const TetrahedralMesh &mesh = bounds.body_of_velocity.mesh;
    for (unsigned int t = 0; t < mesh.tetrahedra.size(); ++t)
      {
        const CornerVelocities &v = bounds.velocity.velocity[t];
        velocities.push_back(
          {{v[0], v[1], v[2], v[3], 0.25 * (v[0] + v[1] + v[2] + v[3])}});
        work.push_back(bounds.velocity.dissipation[t] /
                       volume(mesh.corners(mesh.tetrahedra[t])));
      }
    return {body, bounds.stress, velocities, bounds.gaps, work};
  }
} // namespace ElastoPlastic
