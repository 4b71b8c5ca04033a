// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/conic/local_algebra.h"
#include "bounds/conic/yield_conditions.h"
#include "bounds/mesh/integration.h"
#include "bounds/stress/johnson_mercier.h"
#include "bounds/stress/stress_program.h"

// What StressProgram does with the sides of the triangles.

namespace ElastoPlastic
{
  using namespace JohnsonMercier;

  // The work of given tractions is on the right-hand side.
  void
  StressProgram::number_equations()
  {
    std::vector<double> values, growth;
    for (unsigned int s = 0; s < body.mesh.sides.size(); ++s)
      {
        const SplitMesh::Side &side   = body.mesh.sides[s];
        const Tensor<1, 2>     normal = body.mesh.normal(side);
        equations.emplace_back(degree + 1);
        for (unsigned int c = 0; c < 2; ++c)
          {
            const auto &component = body.conditions[s].components[c];
            const auto  load      = point_forces(s, [&](const Point<2> &x) {
              return body.load(component, normal, x);
            });
            const auto  more      = point_forces(s, [&](const Point<2> &x) {
              return body.load_factor_unit * body.growth(component, normal, x);
            });
            for (unsigned int i = 0; i <= degree; ++i)
              {
                equations[s][i][c] = numbers::invalid_unsigned_int;
                if (component.type == SideConditionType::displacement ||
                    is_on_axis(s, i))
                  continue;
                equations[s][i][c] = values.size();
                values.push_back(load[i]);
                growth.push_back(more[i]);
              }
          }
      }
    program.right_hand_side = Vector<double>(values.begin(), values.end());
    if (body.load_factor_unit > 0)
      program.growth = Vector<double>(growth.begin(), growth.end());
  }



  bool
  StressProgram::is_on_axis(const unsigned int side, const unsigned int i) const
  {
    const auto &vertices = body.mesh.sides[side].vertices;
    const bool  first    = body.is_on_axis(body.mesh.vertices[vertices[0]]),
               last      = body.is_on_axis(body.mesh.vertices[vertices[1]]);
    return (first && i == 0) || (last && i == degree) || (first && last);
  }



  double
  StressProgram::share_of_side(const unsigned int side) const
  {
    return body.mesh.length(body.mesh.sides[side]) /
           ((degree + 1.) * body.length_unit);
  }



  std::vector<double>
  StressProgram::point_forces(
    const unsigned int                             side,
    const std::function<double(const Point<2> &)> &load) const
  {
    const auto  of_load      = moments(side, [&](const Point<2> &x) {
      return body.weight(x) / body.weight_unit() * load(x);
    });
    const auto &coefficients = Bernstein::side_coefficients_of_moments(degree);
    std::vector<double> forces(degree + 1);
    for (unsigned int i = 0; i <= degree; ++i)
      for (unsigned int j = 0; j <= degree; ++j)
        forces[i] += share_of_side(side) / body.stress_unit *
                     coefficients(i, j) * of_load[j] / (degree + 1.);
    return forces;
  }



  void
  StressProgram::add_sides(const unsigned int t)
  {
    const SplitMesh::Triangle &triangle = body.mesh.triangles[t];
    const auto                 corners  = body.mesh.corners(triangle);
    ConicBlock                &block    = program.blocks[t];
    const unsigned int         n        = block.linear_cost.size();

    FullMatrix<double> in_plane(n_values(degree), n),
      tractions(n_tractions(degree), n);
    for (unsigned int i = 0; i < in_plane.m(); ++i)
      for (unsigned int j = 0; j < n; ++j)
        in_plane(i, j) =
          point_stresses[t](n_stress_components * (i / 3) + i % 3, j);
    traction_matrix(corners, degree).mmult(tractions, in_plane);

    sides.emplace_back();
    for (unsigned int k = 0; k < 3; ++k)
      {
        SideOfTriangle &side = sides.back()[k];
        side.side            = triangle.sides[k];
        side.forces.resize(degree + 1);
        for (unsigned int i = 0; i <= degree; ++i)
          for (unsigned int c = 0; c < 2; ++c)
            {
              Vector<double> &force = side.forces[i][c];
              force.reinit(n);
              LocalAlgebra::add_transposed_product(
                force.begin(),
                tractions,
                force_of_tractions(t, k, i, c).begin());

              const unsigned int equation = equations[side.side][i][c];
              if (equation != numbers::invalid_unsigned_int)
                block.add_to_equation(equation, force);
            }
      }
  }



  Vector<double>
  StressProgram::force_of_tractions(const unsigned int t,
                                    const unsigned int k,
                                    const unsigned int i,
                                    const unsigned int component) const
  {
    const SplitMesh::Triangle &triangle = body.mesh.triangles[t];
    const unsigned int         s        = triangle.sides[k];
    const bool                 same_direction =
      body.mesh.sides[s].vertices[0] == triangle.vertices[k];
    const unsigned int local_i = same_direction ? i : degree - i;

    Vector<double> force(n_tractions(degree));
    for (unsigned int d = 0; d < 2; ++d)
      force[traction_index(degree, k, local_i, d)] =
        share_of_side(s) *
        body.conditions[s].components[component].direction[d];
    return force;
  }



  double
  StressProgram::given_multiplier(const unsigned int side,
                                  const unsigned int i,
                                  const unsigned int component) const
  {
    return -moments(side,
                    body.conditions[side].components[component].value)[i] /
           (body.strain_unit * body.length_unit);
  }



  std::vector<double>
  StressProgram::moments(const unsigned int                             side,
                         const std::function<double(const Point<2> &)> &f) const
  {
    const auto         &vertices = body.mesh.sides[side].vertices;
    std::vector<double> result(degree + 1);
    integrate_on_side(body.mesh.vertices[vertices[0]],
                      body.mesh.vertices[vertices[1]],
                      [&](const double t, const Point<2> &x, const double w) {
                        const auto functions =
                          Bernstein::side_functions(degree, t);
                        for (unsigned int i = 0; i <= degree; ++i)
                          result[i] += (degree + 1.) * w * f(x) * functions[i];
                      });
    return result;
  }
} // namespace ElastoPlastic
