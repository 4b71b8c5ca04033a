// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "equilibrium/integration.h"
#include "equilibrium/johnson_mercier.h"
#include "equilibrium/limit_load.h"
#include "equilibrium/stress_problem.h"

namespace ElastoPlastic
{
  namespace
  {
    using namespace JohnsonMercier;



    /// int tau : e(v) over a triangle, the product of two linear functions on
    /// each subtriangle.
    double
    power(const PlaneBody &body, const LimitLoad &bounds, const unsigned int t)
    {
      const auto rates = strains(body.mesh, bounds.velocity.velocity, t);
      double     sum   = 0;
      for (unsigned int subtriangle = 0; subtriangle < 3; ++subtriangle)
        {
          const auto rate = on_subtriangle(rates, subtriangle);
          sum +=
            integrate_product([&](const unsigned int i, const unsigned int j) {
              return stress_at(bounds.stress.in_plane[t], subtriangle, i) *
                     rate[j];
            });
        }
      return area(body.mesh.corners(body.mesh.triangles[t])) / 3. * sum;
    }
  } // namespace



  LimitLoad
  bound_limit_load(const PlaneBody &body)
  {
    LimitLoad bounds;
    bounds.stress   = maximize_force(body);
    bounds.velocity = minimize_plastic_work(body);
    for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
      bounds.gaps.push_back(bounds.velocity.dissipation[t] -
                            power(body, bounds, t));
    return bounds;
  }
} // namespace ElastoPlastic
