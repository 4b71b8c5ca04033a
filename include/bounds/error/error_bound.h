// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_error_error_bound_h
#define bounds_error_error_bound_h

#include <numeric>
#include <vector>

#include "bounds/mechanism/quadratic_field.h"
#include "bounds/stress/stress_field.h"

namespace ElastoPlastic
{
  /// The sum of energy and complementary energy of a displacement (v, V) and of
  /// stresses tau that both are admissible, in parts none of which is negative:
  ///   Pi(v, V) + J(tau) = int W(eps(v)) + W*(tau) - tau : eps(v) dx
  ///                       + int p (g - V - v_d) ds.
  /// With the exact stresses sigma, 1/2 |sigma - tau|^2 in the norm of
  /// the elastic energy is less or equal (doc/theory, "Guaranteed error").
  struct ErrorBound
  {
    /// The integrals over simplices.
    std::vector<double> of_simplices;
    /// Of faces under the indenter.
    std::vector<double> of_faces;

    double
    of_body() const
    {
      return std::accumulate(of_simplices.begin(), of_simplices.end(), 0.);
    }
    double
    of_contact() const
    {
      return std::accumulate(of_faces.begin(), of_faces.end(), 0.);
    }
    double
    total() const
    {
      return of_body() + of_contact();
    }

    /// By simplices, the faces counting for the simplex they belong to.
    template <int dim>
    std::vector<double>
    indicators(const SplitMesh<dim> &mesh) const
    {
      std::vector<double> result = of_simplices;
      for (unsigned int t = 0; t < result.size(); ++t)
        for (const unsigned int face : mesh.simplices[t].faces)
          result[t] += of_faces[face];
      return result;
    }
  };



  /// Lowers @p displacement near the contact surface until no point of a face
  /// penetrates the indenter, which has moved down by @p depth. A solution of
  /// the displacement method does so between its nodes. The gap is enclosed as
  /// FaceGap says, which is certain for convex indenters.
  /// @throws ConvergenceError, see FaceGap
  template <int dim>
  void
  remove_penetration(QuadraticField<dim>  &displacement,
                     const SplitBody<dim> &body,
                     const double          depth);

  /// @p displacement must not penetrate the indenter; @p stress must satisfy
  /// equilibrium and yield condition. Tractions of the body
  /// that are not linear on a face are taken as the linear ones with the same
  /// moments. The energy W, which is no polynomial, is bounded from above, as
  /// is the gap (see FaceGap). @throws ConvergenceError if the displacement is
  /// not what the supports prescribe.
  template <int dim>
  ErrorBound
  bound_error(const SplitBody<dim>      &body,
              const QuadraticField<dim> &displacement,
              const double               depth,
              const StressField<dim>    &stress);
} // namespace ElastoPlastic

#endif
