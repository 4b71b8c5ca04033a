// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_stress_local_stresses_h
#define bounds_stress_local_stresses_h

#include <deal.II/lac/full_matrix.h>

#include <vector>

#include "bounds/body/plane_body.h"
#include "bounds/stress/johnson_mercier.h"

/// The stresses that the equilibrium method chooses from on one triangle. They
/// are Johnson-Mercier stresses S of the section that the mesh shows; in a body
/// of revolution, the stress times the distance r from the axis. With it, its
/// equations
///   d_r S_rr + d_z S_rz - sigma_tt = 0,   d_r S_rz + d_z S_zz = 0
/// are those of a plane but for the circumferential stress sigma_tt. That is
/// defined by the first of them: on each subtriangle a polynomial whose degree
/// is one less than that of S. On the axis, S is zero, as it is for all bounded
/// stresses.
///
/// "Weighted" is S, with 33 for its component r sigma_tt; weights are those of
/// PlaneBody, relative to its unit.
namespace ElastoPlastic::LocalStresses
{
  using namespace dealii;

  /// At the points that coefficients belong to: they are the coefficients of
  /// the weight, which is linear.
  std::vector<double>
  weights(const PlaneBody   &body,
          const unsigned int triangle,
          const unsigned int degree);

  /// The points off the axis.
  std::vector<unsigned int>
  points_off_axis(const PlaneBody   &body,
                  const unsigned int triangle,
                  const unsigned int degree);

  /// All weighted stresses, by values: see JohnsonMercier::basis(). There are
  /// less where the triangle touches the axis.
  FullMatrix<double>
  basis(const PlaneBody   &body,
        const unsigned int triangle,
        const unsigned int degree);

  /// Those that are in equilibrium: 9 of the first, 18 of the second degree in
  /// the plane; 12 and 27 in a body of revolution, less at the axis.
  FullMatrix<double>
  equilibrated_basis(const PlaneBody   &body,
                     const unsigned int triangle,
                     const unsigned int degree);

  /// The coefficients of the circumferential stress on the subtriangles that
  /// goes with weighted stresses given by values, in the units of the body.
  FullMatrix<double>
  circumferential_matrix(const PlaneBody   &body,
                         const unsigned int triangle,
                         const unsigned int degree);

  /// What turns these coefficients into those of the weighted component 33.
  FullMatrix<double>
  weighting_matrix(const PlaneBody   &body,
                   const unsigned int triangle,
                   const unsigned int degree);

  /// What turns weighted stresses, four components at each point, into the
  /// stresses for which the yield condition is asked for: a coefficient over
  /// that of the weight, at the points off the axis. If these satisfy it, all
  /// of the body does: with coefficients S_a of S and r_a of r,
  ///   |dev S| <= sum_a B_a |dev S_a| <= sum_a B_a r_a R = r R.
  FullMatrix<double>
  yield_points(const PlaneBody   &body,
               const unsigned int triangle,
               const unsigned int degree);
} // namespace ElastoPlastic::LocalStresses

#endif
