// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef equilibrium_local_stresses_h
#define equilibrium_local_stresses_h

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

#include "equilibrium/johnson_mercier.h"
#include "equilibrium/plane_body.h"

/// The stresses that the equilibrium method chooses from on one triangle. They
/// are Johnson-Mercier stresses S of the section that the mesh shows; in a body
/// of revolution, the stress times the distance r from the axis. With it, its
/// equations
///   d_r S_rr + d_z S_rz - sigma_tt = 0,   d_r S_rz + d_z S_zz = 0
/// are those of a plane but for the circumferential stress sigma_tt. That is
/// defined by the first of them, and constant on each subtriangle. On the axis,
/// S is zero, as it is for all bounded stresses.
///
/// "Weighted" is S, with 33 for its component r sigma_tt; weights are those of
/// PlaneBody, relative to its unit.
namespace ElastoPlastic::LocalStresses
{
  using namespace dealii;

  /// At the corners of the subtriangles.
  std::array<double, JohnsonMercier::n_points>
  weights(const PlaneBody &body, const unsigned int triangle);

  /// The corners of the subtriangles off the axis.
  std::vector<unsigned int>
  points_off_axis(const PlaneBody &body, const unsigned int triangle);

  /// All weighted stresses, by values (27 x n): see
  /// JohnsonMercier::shape_functions(). n is 15, less where the triangle
  /// touches the axis.
  FullMatrix<double>
  shape_functions(const PlaneBody &body, const unsigned int triangle);

  /// Those that are in equilibrium (27 x n): 9 in the plane, and 12 in a body
  /// of revolution, or 8 or 4 if a vertex or a side is on the axis.
  FullMatrix<double>
  equilibrated_basis(const PlaneBody &body, const unsigned int triangle);

  /// The circumferential stress on the subtriangles that goes with weighted
  /// stresses given by values (3 x 27), in the units of the body.
  FullMatrix<double>
  circumferential_matrix(const PlaneBody &body, const unsigned int triangle);

  /// What turns weighted stresses, four components at each corner of the
  /// subtriangles, into the stresses for which the yield condition is asked for
  /// (4 m x 36): those at the corners off the axis. On the axis, the stress is
  /// a mean of those at the other corners of the subtriangle.
  FullMatrix<double>
  yield_points(const PlaneBody &body, const unsigned int triangle);
} // namespace ElastoPlastic::LocalStresses

#endif
