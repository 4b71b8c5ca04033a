// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/body/hencky_material.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/local_algebra.h"
#include "bounds/conic/yield_conditions.h"
#include "bounds/stress/johnson_mercier.h"
#include "bounds/stress/local_stresses.h"
#include "bounds/stress/stress_program.h"

namespace ElastoPlastic
{
  using namespace JohnsonMercier;

  // The circumferential stress is a derivative of S, with rounding errors that
  // grow as triangles become small: the component 33 follows from it.
  void
  StressProgram::add_stress(StressField          &field,
                            const Vector<double> &values) const
  {
    const unsigned int  t = field.in_plane.size();
    std::vector<double> across(n_points(degree));
    field.in_plane.emplace_back(n_values(degree));
    for (unsigned int p = 0; p < n_points(degree); ++p)
      {
        for (unsigned int c = 0; c < 3; ++c)
          field.in_plane[t][3 * p + c] = values[n_stress_components * p + c];
        across[p] = values[n_stress_components * p + 3];
      }
    if (out_of_plane == OutOfPlaneStress::circumferential)
      {
        Vector<double> stress(n_points(degree - 1)), weighted(n_points(degree));
        LocalStresses::circumferential_matrix(body, t, degree)
          .vmult(stress, field.in_plane[t]);
        LocalStresses::weighting_matrix(body, t, degree)
          .vmult(weighted, stress);
        stress /= body.length_unit;
        weighted *= body.weight_unit() / body.length_unit;
        field.circumferential.emplace_back(stress.begin(), stress.end());
        across.assign(weighted.begin(), weighted.end());
      }
    field.out_of_plane.push_back(across);
  }



  StressField
  StressProgram::solve(const double tolerance) const
  {
    const ConicSolution solution = minimize(program, tolerance);
    const ConicLayout   layout(program);

    StressField field;
    field.degree = degree;
    field.pressure.assign(body.mesh.sides.size(),
                          std::vector<double>(degree + 1));
    const unsigned int n_triangles = body.mesh.triangles.size();
    for (unsigned int t = 0; t < n_triangles; ++t)
      {
        Vector<double>      values(point_stresses[t].m());
        const double *const x = solution.x.begin() + layout.unknowns[t];
        LocalAlgebra::add_product(values.begin(), point_stresses[t], x);
        field.displacement.push_back(displacement_of(
          t,
          strain_moments(t, values, solution.z.begin() + layout.rows[t]),
          solution.y));
        values *= body.stress_unit * body.weight_unit();
        add_stress(field, values);
      }
    set_pressure(field, solution.x.begin() + layout.unknowns[n_triangles]);
    if (program.n_dense_rows > 0)
      field.depth = -body.strain_unit * body.length_unit *
                    solution.y[solution.y.size() - 1];
    field.load_factor = body.load_factor_unit * solution.load_factor;
    field.cost =
      solution.cost * force_unit() * body.strain_unit * body.length_unit;
    field.relative_gap = solution.relative_gap;
    field.n_iterations = solution.n_iterations;
    field.is_optimal   = solution.is_optimal;
    return field;
  }



  // Where it comes to the axis, the weighted pressure is zero: there, the
  // pressure is that of the coefficient beside it.
  void
  StressProgram::set_pressure(StressField &field, const double *forces) const
  {
    for (unsigned int i = 0; i < contact_points.size(); ++i)
      {
        const auto [s, point] = contact_points[i];
        const auto    &ends   = body.mesh.sides[s].vertices;
        const Point<2> a      = body.mesh.vertices[ends[0]],
                       b      = body.mesh.vertices[ends[1]];
        const double pressure =
          forces[i] * body.stress_unit * body.weight_unit() /
          (share_of_side(s) *
           body.weight(Point<2>(a + 1. * point / degree * (b - a))));
        field.pressure[s][point] = pressure;
        if (point == 1 && is_on_axis(s, 0))
          field.pressure[s][0] = pressure;
        if (point + 1 == degree && is_on_axis(s, degree))
          field.pressure[s][degree] = pressure;
        field.force += force_unit() * vertical_part(i) * forces[i];
      }
  }



  // sigma_33 follows the others where it is their mean; where it is an unknown,
  // its own derivative vanishes; where it is the circumferential stress, its
  // derivative is the mean of u_h along r, which displacement_of() finds from
  // the others.
  Vector<double>
  StressProgram::strain_moments(const unsigned int    t,
                                const Vector<double> &stress,
                                const double         *z) const
  {
    Vector<double> moments(stress.size());
    if (has_energy)
      elastic_energy(t).vmult(moments, stress);
    if (HenckyMaterial::yields(body.materials[t]))
      {
        ConicBlock block(stress.size());
        ElastoPlastic::add_yield_conditions(block,
                                            LocalStresses::yield_points(body,
                                                                        t,
                                                                        degree),
                                            /* radius = */ 1.);
        LocalAlgebra::add_transposed_product(moments.begin(),
                                             block.cone_matrix,
                                             z);
      }

    Vector<double> in_plane(n_values(degree));
    for (unsigned int p = 0; p < n_points(degree); ++p)
      {
        const double *const of_point = &moments[n_stress_components * p];
        for (unsigned int c = 0; c < 3; ++c)
          in_plane[3 * p + c] = of_point[c];
        if (out_of_plane == OutOfPlaneStress::mean)
          for (unsigned int c = 0; c < 2; ++c)
            in_plane[3 * p + c] += 0.5 * of_point[3];
      }
    return in_plane;
  }



  double
  StressProgram::multiplier(const unsigned int    side,
                            const unsigned int    i,
                            const unsigned int    component,
                            const Vector<double> &y) const
  {
    const unsigned int equation = equations[side][i][component];
    if (equation != numbers::invalid_unsigned_int)
      return y[equation];
    return has_energy ? given_multiplier(side, i, component) : 0.;
  }



  // For all stresses tau of the triangle, with the traces w of the displacement
  // on its sides,
  //   (strain, tau) + (u_h, div tau) - <w, tau n> = 0.
  // Of these (at most 15 or 36) equations, those of the unknowns have been
  // solved; least squares take out of the others the moments of u_h for the
  // coefficients of div tau, and thus its means over the subtriangles. Such a
  // mean is, for a linear function, 4/9 of the values at the corners k and
  // k + 1 and 1/9 of the third one.
  std::array<Tensor<1, 2>, 3>
  StressProgram::displacement_of(const unsigned int    t,
                                 const Vector<double> &strain_moments,
                                 const Vector<double> &y) const
  {
    const auto corners              = body.mesh.corners(body.mesh.triangles[t]);
    const FullMatrix<double> shapes = LocalStresses::basis(body, t, degree);
    const unsigned int       n      = n_divergences(degree);
    FullMatrix<double>       divergence(n, shapes.n());
    divergence_matrix(corners, degree).mmult(divergence, shapes);
    divergence *= area(corners) / (3. * body.length_unit);

    Vector<double> traction_moments(n_tractions(degree));
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int i = 0; i <= degree; ++i)
        for (unsigned int c = 0; c < 2; ++c)
          traction_moments.add(multiplier(sides[t][k].side, i, c, y),
                               force_of_tractions(t, k, i, c));

    Vector<double> moments = strain_moments;
    traction_matrix(corners, degree).Tvmult(moments, traction_moments, true);
    Vector<double> residual(shapes.n());
    shapes.Tvmult(residual, moments);

    FullMatrix<double> normal_matrix(n, n);
    divergence.mTmult(normal_matrix, divergence);
    normal_matrix.gauss_jordan();
    Vector<double> weighted(n), of_coefficients(n), at_centers(6);
    divergence.vmult(weighted, residual);
    normal_matrix.vmult(of_coefficients, weighted);
    for (unsigned int i = 0; i < n; ++i)
      at_centers[2 * (i / (n / 3)) + i % 2] -=
        body.strain_unit * body.length_unit * of_coefficients[i];

    std::array<Tensor<1, 2>, 3> at_corners;
    for (unsigned int d = 0; d < 2; ++d)
      {
        const double sum =
          at_centers[d] + at_centers[2 + d] + at_centers[4 + d];
        for (unsigned int k = 0; k < 3; ++k)
          at_corners[(k + 2) % 3][d] =
            4. / 3. * sum - 3. * at_centers[2 * k + d];
      }
    return at_corners;
  }
} // namespace ElastoPlastic
