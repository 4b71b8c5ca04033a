// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <numeric>

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
    for (unsigned int t = 0; t < point_stresses.size(); ++t)
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
        for (const SideOfTriangle &side : sides[t])
          if (can_touch(side.side))
            for (unsigned int end = 0; end < 2; ++end)
              field.force -= body.stress_unit * body.length_unit *
                             std::inner_product(side.forces[end][1].begin(),
                                                side.forces[end][1].end(),
                                                x,
                                                0.);
      }
    if (program.n_dense_rows > 0)
      field.depth = -body.strain_unit * body.length_unit *
                    solution.y[solution.y.size() - 1];
    field.cost = solution.cost * body.stress_unit * body.strain_unit *
                 body.length_unit * body.length_unit;
    field.relative_gap = solution.relative_gap;
    field.n_iterations = solution.n_iterations;
    read_displacement(field, solution, layout);
    return field;
  }



  // With each end of a side goes a linear function, and a moment of the
  // displacement: the multiplier of an equation, with the opposite sign; or
  // what is given; or, under the indenter, what its gap leaves, less the
  // clearance.
  void
  StressProgram::read_displacement(StressField         &field,
                                   const ConicSolution &solution,
                                   const ConicLayout   &layout) const
  {
    const double unit = body.strain_unit * body.length_unit;
    field.displacement.resize(body.mesh.sides.size());
    for (unsigned int t = 0; t < sides.size(); ++t)
      for (const SideOfTriangle &side : sides[t])
        {
          auto &displacement = field.displacement[side.side];
          displacement       = {};
          for (unsigned int c = 0; c < 2; ++c)
            {
              const auto &component = body.conditions[side.side].components[c];
              std::array<double, 2> moment =
                moments(side.side, component.value);
              for (unsigned int end = 0; end < 2; ++end)
                {
                  const unsigned int equation = equations[side.side][end][c];
                  if (component.type == SideConditionType::contact)
                    moment[end] =
                      unit *
                        (side.contact_costs[end] -
                         solution.z[layout.rows[t] + side.cone_rows[end]]) -
                      field.depth;
                  else if (equation != numbers::invalid_unsigned_int)
                    moment[end] = -unit * solution.y[equation];
                }
              for (unsigned int end = 0; end < 2; ++end)
                displacement[end] +=
                  (2. * moment[end] - moment[1 - end]) * component.direction;
            }
        }
  }
} // namespace ElastoPlastic
