// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "bounds/conic/conic_evaluation.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/tolerances.h"

namespace ElastoPlastic
{
  void
  check_solvability(const ConicProgram  &program,
                    const ConicLayout   &layout,
                    const KktSystem     &system,
                    const ConicSolution &iterate,
                    const KktVector     &residual)
  {
    const Vector<double> slope = system.quadratic_slope(iterate.x);
    Vector<double>       multipliers_product = residual.x; // -(A^T y + G^T z)
    multipliers_product += slope;
    multipliers_product += layout.linear_cost;
    Vector<double> cone_residual = layout.cone_offset; // G x + s
    cone_residual -= residual.z;
    Vector<double> product = program.right_hand_side; // A x - lambda d
    product -= residual.y;

    const double contradiction =
      -(program.right_hand_side * iterate.y) - layout.cone_offset * iterate.z;
    const double live_load = program.live_load.size() > 0 ?
                               std::abs(program.live_load * iterate.y) :
                               0.;
    // (an iterate that satisfies the equations would contradict: on a fine
    // mesh, all local products are small)
    if (std::max(multipliers_product.linfty_norm(), live_load) <
          Tolerance::certificate_of_multipliers * contradiction &&
        std::abs(multipliers_product * iterate.x) < 0.5 * contradiction)
      throw NoSolutionError();

    const double descent = iterate.load_factor - layout.linear_cost * iterate.x;
    const double quadratic_cost = slope * iterate.x;
    if (std::max({quadratic_cost, // (a slope would become small with the mesh)
                  product.linfty_norm(),
                  cone_residual.linfty_norm()}) <
        Tolerance::certificate_of_direction * descent)
      throw UnboundedError();
  }
} // namespace ElastoPlastic
