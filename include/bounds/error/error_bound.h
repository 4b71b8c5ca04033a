// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_error_error_bound_h
#define bounds_error_error_bound_h

#include <vector>

#include "bounds/body/plane_body.h"
#include "bounds/mechanism/quadratic_field.h"
#include "bounds/mechanism/space_quadratic_field.h"
#include "bounds/stress/space_stress.h"
#include "bounds/stress/stress_field.h"

namespace ElastoPlastic
{
  /// The sum of energy and complementary energy of a displacement (v, V) and of
  /// stresses tau that both are admissible, in parts none of which is negative:
  ///   Pi(v, V) + J(tau) = int W(eps(v)) + W*(tau) - tau : eps(v) dx
  ///                       + int p (g - V - v_2) ds.
  /// With the exact stresses sigma, 1/2 |sigma - tau|^2 in the norm of
  /// the elastic energy is less or equal (doc/theory, "Guaranteed error").
  struct ErrorBound
  {
    /// The integrals over triangles, or tetrahedra.
    std::vector<double> of_simplices;
    /// Of sides, or faces, under the indenter.
    std::vector<double> of_faces;

    double
    of_body() const;
    double
    of_contact() const;
    double
    total() const;

    /// By triangles, the sides counting for the triangle they belong to; or by
    /// tetrahedra with their faces.
    std::vector<double>
    indicators(const SplitMesh &mesh) const;
    std::vector<double>
    indicators(const TetrahedralMesh &mesh) const;
  };



  /// Lowers @p displacement near the contact surface until no point of a side
  /// penetrates the indenter, which has moved down by @p depth. A solution of
  /// the displacement method does so between its nodes. The gap is enclosed as
  /// SideGap says, which is certain for convex indenters.
  void
  remove_penetration(QuadraticField  &displacement,
                     const PlaneBody &body,
                     const double     depth);

  /// The same in space, on faces. @throws ConvergenceError, see FaceGap
  void
  remove_penetration(SpaceQuadraticField &displacement,
                     const SpaceBody     &body,
                     const double         depth);

  /// @p displacement must not penetrate the indenter; @p stress must satisfy
  /// equilibrium and yield condition. Tractions of the body
  /// that are not linear on a side are taken as the linear ones with the same
  /// moments. The energy W, which is no polynomial, is bounded from above, as
  /// is the gap (see SideGap). @throws ConvergenceError if the displacement is
  /// not what the supports prescribe.
  ErrorBound
  bound_error(const PlaneBody      &body,
              const QuadraticField &displacement,
              const double          depth,
              const StressField    &stress);

  /// The same in space.
  ErrorBound
  bound_error(const SpaceBody           &body,
              const SpaceQuadraticField &displacement,
              const double               depth,
              const SpaceStressField    &stress);
} // namespace ElastoPlastic

#endif
