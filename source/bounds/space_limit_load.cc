// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/body/circumscribed.h"
#include "bounds/space_limit_load.h"
#include "bounds/stress/stress_problem.h"
#include "bounds/stress/tetrahedron_stress.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The power of the stresses in a tetrahedron. The strain rate is constant,
    /// and all parts have the same volume.
    double
    power_inside(const SpaceBody      &body,
                 const SpaceLimitLoad &bounds,
                 const unsigned int    t)
    {
      constexpr unsigned int n_points = TetrahedronStress::n_points;

      const Tetrahedron corners = body.mesh.corners(body.mesh.tetrahedra[t]);
      SymmetricTensor<2, 3> sum;
      for (unsigned int k = 0; k < 4; ++k)
        for (unsigned int i = 0; i < 4; ++i)
          sum += bounds.stress.at(t, k, i);
      return volume(corners) / n_points *
             (sum * strain_rate(corners, bounds.velocity.velocity[t]));
    }



    /// That of the shear stress in what slides along a face: tractions and
    /// jumps are linear.
    double
    power_on_face(const SpaceBody      &body,
                  const SpaceLimitLoad &bounds,
                  const unsigned int    f)
    {
      const auto        &face        = body.mesh.faces[f];
      const unsigned int t           = face.neighbors[0];
      const auto        &tetrahedron = body.mesh.tetrahedra[t];
      unsigned int       k           = 0;
      while (tetrahedron.faces[k] != f)
        ++k;
      const Tensor<1, 3> n = outward_normal(body.mesh.corners(tetrahedron), k);
      const auto jumps     = velocity_jumps(body, bounds.velocity.velocity, f);

      double sum = 0;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Tensor<1, 3> traction =
            bounds.stress.at(t, k, corner_of_face(k, i)) * n;
          const Tensor<1, 3> shear = traction - (traction * n) * n;
          for (unsigned int j = 0; j < 3; ++j)
            sum -= (i == j ? 2. : 1.) * (shear * jumps[j]);
        }
      return area(body.mesh.corners(face)) / 12. * sum;
    }



    // Also of stresses on another mesh, the power in a tetrahedron or on a face
    // is not more than the work of velocities that change no volume: that
    // follows from the yield condition alone.
    void
    find_gaps(SpaceLimitLoad &bounds)
    {
      const SpaceBody &body = bounds.body_of_velocity;
      bounds.gaps           = bounds.velocity.dissipation;
      for (unsigned int t = 0; t < bounds.gaps.size(); ++t)
        bounds.gaps[t] -= power_inside(body, bounds, t);
      for (unsigned int f = 0; f < body.mesh.faces.size(); ++f)
        if (slip_takes_work(body, f))
          for (const unsigned int t : body.mesh.faces[f].neighbors)
            if (t != numbers::invalid_unsigned_int)
              bounds.gaps[t] -= power_on_face(body, bounds, f) /
                                (body.mesh.faces[f].is_inside() ? 2. : 1.);
    }
  } // namespace



  SpaceLimitLoad
  bound_limit_load(const SpaceBody &body, const double tolerance)
  {
    SpaceLimitLoad bounds;
    bounds.stress           = maximize_load(body, tolerance);
    bounds.body_of_velocity = circumscribe(body);
    bounds.velocity = minimize_plastic_work(bounds.body_of_velocity, tolerance);
    bounds.lower_bound = body.load_factor_unit > 0 ? bounds.stress.load_factor :
                                                     bounds.stress.force;
    bounds.upper_bound = bounds.velocity.bound;
    find_gaps(bounds);
    return bounds;
  }
} // namespace ElastoPlastic
