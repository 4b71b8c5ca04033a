// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "equilibrium/local_algebra.h"
#include "equilibrium/local_stresses.h"
#include "equilibrium/yield_conditions.h"

namespace ElastoPlastic::LocalStresses
{
  namespace
  {
    using namespace JohnsonMercier;



    Triangle
    corners_of(const PlaneBody &body, const unsigned int t)
    {
      return body.mesh.corners(body.mesh.triangles[t]);
    }



    /// The combinations of the columns of @p basis whose product with
    /// @p conditions is zero.
    FullMatrix<double>
    restrict_to_kernel(const FullMatrix<double> &basis,
                       const FullMatrix<double> &conditions)
    {
      FullMatrix<double> product(conditions.m(), basis.n());
      conditions.mmult(product, basis);
      const FullMatrix<double> kernel = LocalAlgebra::kernel(product);
      FullMatrix<double>       restricted(basis.m(), kernel.m());
      basis.mTmult(restricted, kernel);
      return restricted;
    }



    /// Of the divergence on the subtriangles, one @p component times the unit
    /// of length.
    FullMatrix<double>
    divergence_component(const PlaneBody   &body,
                         const unsigned int t,
                         const unsigned int component)
    {
      const FullMatrix<double> divergence =
        divergence_matrix(corners_of(body, t));
      FullMatrix<double> rows(3, n_values);
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int j = 0; j < n_values; ++j)
          rows(k, j) = body.length_unit * divergence(2 * k + component, j);
      return rows;
    }
  } // namespace



  std::array<double, n_points>
  weights(const PlaneBody &body, const unsigned int t)
  {
    std::array<double, n_points> result;
    for (unsigned int k = 0; k < 3; ++k)
      {
        const Triangle subtriangle = subtriangle_of(corners_of(body, t), k);
        for (unsigned int i = 0; i < 3; ++i)
          result[3 * k + i] =
            body.is_on_axis(subtriangle[i]) ?
              0. :
              body.weight(subtriangle[i]) / body.weight_unit();
      }
    return result;
  }



  std::vector<unsigned int>
  points_off_axis(const PlaneBody &body, const unsigned int t)
  {
    const auto                of_points = weights(body, t);
    std::vector<unsigned int> points;
    for (unsigned int p = 0; p < n_points; ++p)
      if (of_points[p] > 0)
        points.push_back(p);
    return points;
  }



  FullMatrix<double>
  shape_functions(const PlaneBody &body, const unsigned int t)
  {
    const FullMatrix<double> all =
      JohnsonMercier::shape_functions(corners_of(body, t));
    const auto         of_points = weights(body, t);
    FullMatrix<double> on_axis(n_values, n_values);
    for (unsigned int i = 0; i < n_values; ++i)
      on_axis(i, i) = of_points[i / 3] > 0 ? 0. : 1.;
    return on_axis.linfty_norm() > 0 ? restrict_to_kernel(all, on_axis) : all;
  }



  // The stresses, not the weighted ones, are what all triangles have of the
  // same size.
  FullMatrix<double>
  equilibrated_basis(const PlaneBody &body, const unsigned int t)
  {
    if (!body.is_axisymmetric())
      return JohnsonMercier::equilibrated_basis(corners_of(body, t));
    FullMatrix<double> basis =
      restrict_to_kernel(shape_functions(body, t),
                         divergence_component(body, t, 1));
    basis *= weights(body, t)[2]; // at the centre of gravity
    return basis;
  }



  FullMatrix<double>
  circumferential_matrix(const PlaneBody &body, const unsigned int t)
  {
    return divergence_component(body, t, 0);
  }



  FullMatrix<double>
  yield_points(const PlaneBody &body, const unsigned int t)
  {
    const auto         of_points = weights(body, t);
    const auto         points    = points_off_axis(body, t);
    FullMatrix<double> result(n_stress_components * points.size(),
                              n_stress_components * n_points);
    for (unsigned int i = 0; i < points.size(); ++i)
      for (unsigned int c = 0; c < n_stress_components; ++c)
        result(n_stress_components * i + c,
               n_stress_components * points[i] + c) = 1. / of_points[points[i]];
    return result;
  }
} // namespace ElastoPlastic::LocalStresses
