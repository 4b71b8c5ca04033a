// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_velocity_field_h
#define equilibrium_velocity_field_h

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

#include "equilibrium/plane_body.h"
#include "equilibrium/quadratic_field.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A mechanism of collapse, and the bound of the limit load that it gives.
  struct VelocityField
  {
    /// The indenter moves down by 1.
    QuadraticField velocity;

    /// By triangles: an upper bound of the plastic work.
    std::vector<double> dissipation;

    /// Plastic work less that of the given tractions, per unit of depth.
    double force = 0;
    /// The relative_divergence() in plane strain, where there should be none.
    double       divergence   = 0;
    unsigned int n_iterations = 0;
    /// False if rounding errors have ended the minimisation early.
    bool is_optimal = true;
  };



  /// The largest divergence of a @p velocity, whatever its sign, relative to
  /// its largest rate of strain; zero if it is rigid.
  double
  relative_divergence(const SplitMesh &mesh, const QuadraticField &velocity);

  /// The norm |e| of a plastic strain rate whose in-plane components are
  /// @p rate: out of plane it is zero, or, in plane stress, keeps the volume.
  double
  plastic_rate(const PlaneBody &body, const SymmetricTensor<2, 2> &rate);
} // namespace ElastoPlastic

#endif
