// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "bounds/conic/interior_point.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  NoSolutionError::NoSolutionError()
    : ConvergenceError(
        "The problem that the interior point method solves has "
        "no solution.")
  {}



  UnboundedError::UnboundedError()
    : ConvergenceError(
        "The cost that the interior point method minimises has "
        "no lower bound.")
  {}



  void
  check_solvability(const ConicProgram  &program,
                    const ConicLayout   &layout,
                    const ConicSolution &iterate,
                    const KktVector     &residual)
  {
    Vector<double> multipliers_product(residual.x.size()), // A^T y + G^T z
      cone_residual(residual.z.size());                    // G x + s
    const Vector<double> slope = quadratic_slope(program, layout, iterate.x);
    double               linear_cost = -iterate.load_factor, offset_product = 0;
    for (unsigned int b = 0; b < program.blocks.size(); ++b)
      {
        const ConicBlock &block = program.blocks[b];
        for (unsigned int j = 0; j < block.linear_cost.size(); ++j)
          {
            const unsigned int row = layout.unknowns[b] + j;
            multipliers_product[row] =
              -residual.x[row] - slope[row] - block.linear_cost[j];
            linear_cost += block.linear_cost[j] * iterate.x[row];
          }
        for (unsigned int i = 0; i < block.cone_offset.size(); ++i)
          {
            const unsigned int row = layout.rows[b] + i;
            cone_residual[row]     = block.cone_offset[i] - residual.z[row];
            offset_product += block.cone_offset[i] * iterate.z[row];
          }
      }
    Vector<double> product = program.right_hand_side; // A x - lambda d
    product -= residual.y;

    const double contradiction =
      -(program.right_hand_side * iterate.y) - offset_product;
    const double live_load = program.live_load.size() > 0 ?
                               std::abs(program.live_load * iterate.y) :
                               0.;
    // (an iterate that satisfies the equations would contradict: on a fine
    // mesh, all local products are small)
    if (std::max(multipliers_product.linfty_norm(), live_load) <
          Tolerance::certificate_of_multipliers * contradiction &&
        std::abs(multipliers_product * iterate.x) < 0.5 * contradiction)
      throw NoSolutionError();

    const double descent        = -linear_cost;
    const double quadratic_cost = slope * iterate.x;
    if (std::max({quadratic_cost, // (a slope would become small with the mesh)
                  product.linfty_norm(),
                  cone_residual.linfty_norm()}) <
        Tolerance::certificate_of_direction * descent)
      throw UnboundedError();
  }
} // namespace ElastoPlastic
