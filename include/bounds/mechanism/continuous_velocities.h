// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_mechanism_continuous_velocities_h
#define bounds_mechanism_continuous_velocities_h

#include <vector>

#include "bounds/body/split_body.h"
#include "bounds/mechanism/velocity_basis.h"

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



  /// Continuous velocities that may change the volume. They are zero at
  /// supports, see free_directions_of_nodes().
  ///
  /// In the plane and in space, they are quadratic on each simplex, and the
  /// strain rate is linear. In a body of revolution, v_r = (r / L) w with a
  /// quadratic w and the length unit L, and v_z is cubic. So the rates e_rr =
  /// (w + r d_r w) / L, e_tt = w / L, e_zz = d_z v_z and 2 e_rz = r d_z w / L +
  /// d_r v_z are quadratic polynomials, and those without a change of volume,
  /// v_r = -r d_z chi and v_z = 2 chi + r d_r chi with a cubic chi, are among
  /// them: so they are not lost as the angle of friction tends to zero.
  template <int dim>
  VelocityBasis<dim>
  continuous_velocities(const SplitBody<dim> &body);

  /// Those of a body of revolution.
  VelocityBasis<2>
  revolution_velocities(const SplitBody<2> &body);
} // namespace ElastoPlastic

#endif
