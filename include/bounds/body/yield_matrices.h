// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_yield_matrices_h
#define bounds_body_yield_matrices_h

#include <deal.II/lac/full_matrix.h>

#include <array>

#include "bounds/body/split_body.h"

// Yield conditions as second-order cones, |M d| <= R, and the plastic work of
// strain rates, R |M^-T e|: deviatoric stresses d and rates e are given by
// coordinates in the basis of deviator_matrix(), R is the yield radius. With
// Hill's criterion q, M is the factor of (2/3) q^2 = |M d|^2; it is the
// identity with that of von Mises.
//
// M is lower triangular. In the plane the last coordinate is that out of plane:
// the first two rows of M belong to the stresses that admit most, where the
// last one, M d, is zero, and to rates without any out of plane.

namespace ElastoPlastic
{
  /// What turns the components of a stress into M d.
  template <int dim>
  FullMatrix<double>
  stress_matrix(const Material<double> &material);

  /// What turns the components of a strain rate, each counting once, into
  /// M^-T e.
  template <int dim>
  FullMatrix<double>
  rate_matrix(const Material<double> &material);

  /// The stress out of plane with which the yield condition admits most stress
  /// in the plane: what the components 11, 22 and 12 contribute.
  std::array<double, 3>
  weights_out_of_plane(const Material<double> &material);

  /// What turns a slip along a face, by components in its tangents(), into a
  /// vector with the norm N: in one of its simplices the slip takes the plastic
  /// work k N, k being the yield stress in shear by its yield radius.
  template <int dim>
  FullMatrix<double>
  slip_factor(const SplitBody<dim> &body,
              const unsigned int    face,
              const unsigned int    simplex);

  /// The same for the neighbour of the face that resists less, on an average,
  /// with SplitBody::shear_strength() for k.
  template <int dim>
  FullMatrix<double>
  slip_factor(const SplitBody<dim> &body, const unsigned int face);
} // namespace ElastoPlastic

#endif
