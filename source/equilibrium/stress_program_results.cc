// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "equilibrium/hencky_material.h"
#include "equilibrium/interior_point.h"
#include "equilibrium/johnson_mercier.h"
#include "equilibrium/local_algebra.h"
#include "equilibrium/local_stresses.h"
#include "equilibrium/stress_program.h"
#include "equilibrium/yield_conditions.h"

namespace ElastoPlastic
{
  using namespace JohnsonMercier;

  namespace
  {
    /// Adds the weighted stress of the next triangle, given by its @p values,
    /// four components at each corner of the subtriangles.
    void
    add_stress(StressField          &field,
               const PlaneBody      &body,
               const unsigned int    t,
               const Vector<double> &values)
    {
      field.in_plane.emplace_back(n_values);
      field.out_of_plane.emplace_back();
      for (unsigned int p = 0; p < n_points; ++p)
        {
          for (unsigned int c = 0; c < 3; ++c)
            field.in_plane[t][3 * p + c] = values[n_stress_components * p + c];
          field.out_of_plane[t][p] = values[n_stress_components * p + 3];
        }
      if (!body.is_axisymmetric())
        return;
      // It is a derivative of S, with rounding errors that grow as triangles
      // become small: they must be the same at all corners.
      const auto weights = LocalStresses::weights(body, t);
      field.circumferential.emplace_back();
      for (unsigned int k = 0; k < 3; ++k)
        {
          const unsigned int center = 3 * k + 2;
          const double       stress = field.out_of_plane[t][center] /
                                (weights[center] * body.weight_unit());
          field.circumferential[t][k] = stress;
          for (unsigned int p = 3 * k; p < 3 * k + 3; ++p)
            field.out_of_plane[t][p] = weights[p] * body.weight_unit() * stress;
        }
    }
  } // namespace



  StressField
  StressProgram::solve(const double tolerance) const
  {
    const ConicSolution solution = minimize(program, tolerance);
    const ConicLayout   layout(program);

    StressField field;
    field.pressure.resize(body.mesh.sides.size());
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
        add_stress(field, body, t, values);
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



  // From the axis on, the weighted pressure is in proportion to r: there, the
  // pressure is that of the other end.
  void
  StressProgram::set_pressure(StressField &field, const double *forces) const
  {
    for (unsigned int i = 0; i < contact_ends.size(); ++i)
      {
        const auto [s, end]         = contact_ends[i];
        const SplitMesh::Side &side = body.mesh.sides[s];
        const auto             at   = [&](const unsigned int e) {
          return body.mesh.vertices[side.vertices[e]];
        };
        const double pressure = 2. * forces[i] * body.stress_unit *
                                body.length_unit * body.weight_unit() /
                                (body.mesh.length(side) * body.weight(at(end)));
        field.pressure[s][end] = pressure;
        if (body.is_on_axis(at(1 - end)))
          field.pressure[s][1 - end] = pressure;
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
                                                                        t),
                                            /* radius = */ 1.);
        LocalAlgebra::add_transposed_product(moments.begin(),
                                             block.cone_matrix,
                                             z);
      }

    Vector<double> in_plane(n_values);
    for (unsigned int p = 0; p < n_points; ++p)
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
                            const unsigned int    end,
                            const unsigned int    component,
                            const Vector<double> &y) const
  {
    const unsigned int equation = equations[side][end][component];
    if (equation != numbers::invalid_unsigned_int)
      return y[equation];
    return has_energy ? given_multiplier(side, end, component) : 0.;
  }



  // For all stresses tau of the triangle, with the traces w of the displacement
  // on its sides,
  //   (strain, tau) + (u_h, div tau) - <w, tau n> = 0.
  // Of these (at most 15) equations, those of the unknowns have been solved;
  // least squares take out of the others the values of u_h at the centres of
  // gravity of the subtriangles, where div tau is constant. Such a value is 4/9
  // of those at the corners k and k + 1 and 1/9 of the third one.
  std::array<Tensor<1, 2>, 3>
  StressProgram::displacement_of(const unsigned int    t,
                                 const Vector<double> &strain_moments,
                                 const Vector<double> &y) const
  {
    const auto corners              = body.mesh.corners(body.mesh.triangles[t]);
    const FullMatrix<double> shapes = LocalStresses::shape_functions(body, t);
    FullMatrix<double>       divergence(6, shapes.n());
    divergence_matrix(corners).mmult(divergence, shapes);
    divergence *= area(corners) / (3. * body.length_unit);

    Vector<double> traction_moments(n_tractions);
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int end = 0; end < 2; ++end)
        for (unsigned int c = 0; c < 2; ++c)
          traction_moments.add(multiplier(sides[t][k].side, end, c, y),
                               force_of_tractions(t, k, end, c));

    Vector<double> moments = strain_moments;
    traction_matrix(corners).Tvmult(moments, traction_moments, true);
    Vector<double> residual(shapes.n());
    shapes.Tvmult(residual, moments);

    FullMatrix<double> normal_matrix(6, 6);
    divergence.mTmult(normal_matrix, divergence);
    normal_matrix.gauss_jordan();
    Vector<double> weighted(6), at_centers(6);
    divergence.vmult(weighted, residual);
    normal_matrix.vmult(at_centers, weighted);
    at_centers *= -body.strain_unit * body.length_unit;

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
