// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_free_directions_h
#define bounds_mechanism_free_directions_h

#include <vector>

#include "bounds/body/split_body.h"

namespace ElastoPlastic
{
  /// The directions in which continuous velocities are free at the vertices of
  /// the mesh, and after these in the middles of its edges: unit vectors at
  /// right angles to each other. The velocity is zero in others, where
  /// SplitBody::support_of() asks for it: across closed faces, and along those
  /// that resist a slip, also of a rough indenter where it reaches. Normals
  /// that differ by Tolerance::small_angle or less hold in one direction, that
  /// of the first.
  template <int dim>
  std::vector<std::vector<Tensor<1, dim>>>
  free_directions_of_nodes(const SplitBody<dim> &body);
} // namespace ElastoPlastic

#endif
