// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/tensors.h"
#include "equilibrium/interior_point.h"
#include "equilibrium/johnson_mercier.h"
#include "equilibrium/local_algebra.h"
#include "equilibrium/stress_program.h"
#include "equilibrium/yield_conditions.h"

namespace ElastoPlastic
{
  StressField
  StressProgram::solve(const double tolerance) const
  {
    const ConicSolution solution = minimize(program, tolerance);
    const ConicLayout   layout(program);

    StressField field;
    field.pressure.resize(body.mesh.sides.size());
    const unsigned int n_triangles = body.mesh.triangles.size();
    for (unsigned int t = 0; t < n_triangles; ++t)
      {
        Vector<double>      values(point_stresses[t].m());
        const double *const x = solution.x.begin() + layout.unknowns[t];
        LocalAlgebra::add_product(values.begin(), point_stresses[t], x);
        values *= body.stress_unit;
        field.in_plane.emplace_back(JohnsonMercier::n_values);
        field.out_of_plane.emplace_back();
        for (unsigned int p = 0; p < JohnsonMercier::n_points; ++p)
          {
            for (unsigned int c = 0; c < 3; ++c)
              field.in_plane[t][3 * p + c] =
                values[n_stress_components * p + c];
            field.out_of_plane[t][p] = values[n_stress_components * p + 3];
          }
      }
    for (unsigned int i = 0; i < contact_sides.size(); ++i)
      for (unsigned int end = 0; end < 2; ++end)
        {
          const unsigned int s = contact_sides[i];
          const double       force =
            body.stress_unit * body.length_unit *
            solution.x[layout.unknowns[n_triangles + i] + end];
          field.pressure[s][end] =
            2. * force / body.mesh.length(body.mesh.sides[s]);
          field.force += force;
        }
    if (program.n_dense_rows > 0)
      field.depth = -body.strain_unit * body.length_unit *
                    solution.y[solution.y.size() - 1];
    field.cost = solution.cost * body.stress_unit * body.strain_unit *
                 body.length_unit * body.length_unit;
    field.relative_gap = solution.relative_gap;
    field.n_iterations = solution.n_iterations;
    return field;
  }



  SymmetricTensor<2, 3>
  StressField::at(const unsigned int triangle,
                  const unsigned int third,
                  const unsigned int corner) const
  {
    return in_space<2>(JohnsonMercier::stress_at(in_plane[triangle],
                                                 third,
                                                 corner),
                       out_of_plane[triangle][3 * third + corner]);
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
  StressField::contact_area(const SplitMesh &mesh) const
  {
    const double threshold = 1e-4 * max_pressure();
    double       area      = 0;
    for (unsigned int s = 0; s < pressure.size(); ++s)
      for (const double at_end : pressure[s])
        if (at_end > threshold)
          area += 0.5 * mesh.length(mesh.sides[s]);
    return area;
  }
} // namespace ElastoPlastic
