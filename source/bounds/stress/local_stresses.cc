// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/conic/local_algebra.h"
#include "bounds/conic/yield_conditions.h"
#include "bounds/stress/local_stresses.h"

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
                         const unsigned int degree,
                         const unsigned int component)
    {
      const FullMatrix<double> divergence =
        divergence_matrix(corners_of(body, t), degree);
      FullMatrix<double> rows(divergence.m() / 2, divergence.n());
      for (unsigned int i = 0; i < rows.m(); ++i)
        for (unsigned int j = 0; j < rows.n(); ++j)
          rows(i, j) = body.length_unit * divergence(2 * i + component, j);
      return rows;
    }
  } // namespace



  std::vector<double>
  weights(const PlaneBody   &body,
          const unsigned int t,
          const unsigned int degree)
  {
    std::vector<double> result;
    for (unsigned int k = 0; k < 3; ++k)
      {
        const Triangle corners = subtriangle_of(corners_of(body, t), k);
        for (const auto &exponents : Bernstein::exponents(degree))
          {
            double weight = 0;
            for (unsigned int i = 0; i < 3; ++i)
              if (!body.is_on_axis(corners[i]))
                weight += Bernstein::point_of(exponents)[i] *
                          body.weight(corners[i]) / body.weight_unit();
            result.push_back(weight);
          }
      }
    return result;
  }



  std::vector<unsigned int>
  points_off_axis(const PlaneBody   &body,
                  const unsigned int t,
                  const unsigned int degree)
  {
    const auto                of_points = weights(body, t, degree);
    std::vector<unsigned int> points;
    for (unsigned int p = 0; p < of_points.size(); ++p)
      if (of_points[p] > 0)
        points.push_back(p);
    return points;
  }



  FullMatrix<double>
  basis(const PlaneBody &body, const unsigned int t, const unsigned int degree)
  {
    const FullMatrix<double> all =
      JohnsonMercier::basis(corners_of(body, t), degree);
    const auto         of_points = weights(body, t, degree);
    FullMatrix<double> on_axis(all.m(), all.m());
    for (unsigned int i = 0; i < all.m(); ++i)
      on_axis(i, i) = of_points[i / 3] > 0 ? 0. : 1.;
    return on_axis.linfty_norm() > 0 ? restrict_to_kernel(all, on_axis) : all;
  }



  // The stresses, not the weighted ones, are what all triangles have of the
  // same size: the weight is that of the centre of gravity.
  FullMatrix<double>
  equilibrated_basis(const PlaneBody   &body,
                     const unsigned int t,
                     const unsigned int degree)
  {
    if (!body.is_axisymmetric())
      return JohnsonMercier::equilibrated_basis(corners_of(body, t), degree);
    FullMatrix<double> equilibrated =
      restrict_to_kernel(basis(body, t, degree),
                         divergence_component(body, t, degree, 1));
    equilibrated *= weights(body, t, /* degree = */ 1)[2];
    return equilibrated;
  }



  FullMatrix<double>
  circumferential_matrix(const PlaneBody   &body,
                         const unsigned int t,
                         const unsigned int degree)
  {
    return divergence_component(body, t, degree, 0);
  }



  // The coefficient a of the product of linear w and f, of degree n - 1, is
  // sum_i a_i / n w_i f_{a - e_i}.
  FullMatrix<double>
  weighting_matrix(const PlaneBody   &body,
                   const unsigned int t,
                   const unsigned int degree)
  {
    const auto         at_corners = weights(body, t, /* degree = */ 1);
    const auto        &exponents  = Bernstein::exponents(degree);
    const unsigned int n_lower    = Bernstein::n_functions(degree - 1);
    FullMatrix<double> matrix(n_points(degree), n_points(degree - 1));
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int a = 0; a < exponents.size(); ++a)
        for (unsigned int i = 0; i < 3; ++i)
          if (exponents[a][i] > 0)
            {
              Bernstein::Exponents lowered = exponents[a];
              --lowered[i];
              matrix(exponents.size() * k + a,
                     n_lower * k + Bernstein::number_of(lowered)) =
                Bernstein::point_of(exponents[a])[i] * at_corners[3 * k + i];
            }
    return matrix;
  }



  FullMatrix<double>
  yield_points(const PlaneBody   &body,
               const unsigned int t,
               const unsigned int degree)
  {
    const auto         of_points = weights(body, t, degree);
    const auto         points    = points_off_axis(body, t, degree);
    FullMatrix<double> result(n_stress_components * points.size(),
                              n_stress_components * of_points.size());
    for (unsigned int i = 0; i < points.size(); ++i)
      for (unsigned int c = 0; c < n_stress_components; ++c)
        result(n_stress_components * i + c,
               n_stress_components * points[i] + c) = 1. / of_points[points[i]];
    return result;
  }
} // namespace ElastoPlastic::LocalStresses
