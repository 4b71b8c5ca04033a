// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_velocity_field_h
#define equilibrium_velocity_field_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <vector>

#include "equilibrium/plane_body.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A mechanism of collapse, and the bound of the limit load that it gives.
  struct VelocityField
  {
    /// At the vertices of the mesh, and at the middle of its sides: quadratic
    /// on each triangle, continuous. The indenter moves down by 1.
    std::vector<Tensor<1, 2>> at_vertices;
    std::vector<Tensor<1, 2>> at_sides;

    /// By triangles: an upper bound of the plastic work.
    std::vector<double> dissipation;

    /// Plastic work less that of the given tractions, per unit of depth.
    double force = 0;
    /// The largest divergence in plane strain, where there should be none,
    /// relative to the largest rate of strain.
    double       divergence   = 0;
    unsigned int n_iterations = 0;
  };



  /// The gradients of the six quadratic shape functions at a @p corner of a
  /// triangle: of those that belong to its corners, then of those that belong
  /// to the middles of its sides.
  std::array<Tensor<1, 2>, 6>
  shape_gradients(const std::array<Point<2>, 3> &corners,
                  const unsigned int             corner);

  /// The norm |e| of a plastic strain rate whose in-plane components are
  /// @p rate: out of plane it is zero, or, in plane stress, keeps the volume.
  double
  plastic_rate(const PlaneBody &body, const SymmetricTensor<2, 2> &rate);



  /// The strain rate of @p field at the corners of a @p triangle.
  std::array<SymmetricTensor<2, 2>, 3>
  strain_rates(const PlaneBody     &body,
               const VelocityField &field,
               const unsigned int   triangle);
} // namespace ElastoPlastic

#endif
