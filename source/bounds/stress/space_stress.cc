// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "bounds/stress/space_stress.h"
#include "bounds/stress/tetrahedron_stress.h"

namespace ElastoPlastic
{
  SymmetricTensor<2, 3>
  SpaceStressField::at(const unsigned int t,
                       const unsigned int part,
                       const unsigned int corner) const
  {
    return TetrahedronStress::stress_from(
      values[t].begin() + TetrahedronStress::value_index(part, corner));
  }



  double
  SpaceStressField::max_pressure() const
  {
    double largest = 0;
    for (const auto &of_face : pressure)
      for (const double p : of_face)
        largest = std::max(largest, p);
    return largest;
  }



  // See StressField::contact_area().
  double
  SpaceStressField::contact_area(const SpaceBody &body) const
  {
    const double threshold = 1e-4 * max_pressure();
    double       result    = 0;
    for (unsigned int f = 0; f < pressure.size(); ++f)
      for (const double p : pressure[f])
        if (p > threshold)
          result += area(body.mesh.corners(body.mesh.faces[f])) / 3.;
    return result;
  }
} // namespace ElastoPlastic
