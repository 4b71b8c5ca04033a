// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "bounds/body/yield_matrices.h"
#include "bounds/conic/dissipation_block.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/tolerances.h"
#include "bounds/conic/yield_conditions.h"
#include "bounds/mechanism/face_view.h"
#include "bounds/mechanism/velocity_basis.h"
#include "bounds/mechanism/velocity_program.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The integrals over a simplex of Bernstein's functions of the strain
    /// rate, in units of the body: positive.
    template <int dim>
    std::vector<double>
    moments_of_rate(const SplitBody<dim> &body,
                    const unsigned int    t,
                    const unsigned int    degree)
    {
      const auto          corners = body.corners_of(t);
      std::vector<double> result =
        Bernstein<dim>::moments(degree, body.weights(corners));
      for (double &moment : result)
        moment *= volume(corners) /
                  (std::pow(body.length_unit, dim - 1) * body.weight_unit());
      return result;
    }



    /// The coefficients in Bernstein's basis of a strain rate of this
    /// @p degree, by what the components of stress_from() do work in.
    template <int dim>
    std::vector<std::array<double, n_stress_components<dim>>>
    components_of_rate(const SplitBody<dim>       &body,
                       const SimplexVelocity<dim> &velocity,
                       const unsigned int          t,
                       const unsigned int          degree)
    {
      constexpr unsigned int          n = n_stress_components<dim>;
      static const FullMatrix<double> units{IdentityMatrix(n)};

      std::vector<std::array<double, n>> result;
      for (const auto &rate :
           Bernstein<dim>::interpolate(degree, [&](const auto &point) {
             return strain_rate_at(body, velocity, t, point);
           }))
        {
          auto &components = result.emplace_back();
          for (unsigned int c = 0; c < n; ++c)
            components[c] = stress_from<dim>(&units(c, 0)) * rate;
        }
      return result;
    }



    // Without friction, the components: of a sheet, 11, 22 and 12. With it, the
    // first unknown is the slope times the mean stress, others are deviators.
    // So the yield condition and the power, moments of rate of volume over
    // slope, are of the same size for any slope, and so are rounding errors. In
    // plane strain the mean is 33, too.
    /// The stress components of a coefficient by its unknowns.
    template <int dim>
    FullMatrix<double>
    components_of_unknowns(const SplitBody<dim> &body, const unsigned int t)
    {
      const bool         is_plane = dim == 2 && !body.is_axisymmetric();
      FullMatrix<double> components(n_stress_components<dim>,
                                    n_stress_components<dim> - is_plane);
      for (unsigned int c = 0; c < components.n(); ++c)
        components(c, c) = 1.;
      if (!body.has_friction())
        return components;
      const double slope = body.friction_slopes[t];
      for (const unsigned int c : {0u, 1u, across<dim>})
        components(c, 0) = slope > 0. ? 1. / slope : 1.;
      components(0, 1) = 1.;
      components(1, 1) = -1.;
      if (!is_plane)
        components(0, across<dim>) = components(1, across<dim>) = -0.5;
      return components;
    }



    // The margin, of the rate of volume over the slope, is a cost of the mean
    // stress times the slope.
    /// Stresses for the coefficients of the strain rate of a simplex.
    template <int dim>
    ConicBlock
    block_of_stresses(const SplitBody<dim>         &body,
                      const VelocityFunctions<dim> &functions,
                      const unsigned int            t,
                      const unsigned int            degree)
    {
      const auto         moments    = moments_of_rate(body, t, degree);
      const auto         components = components_of_unknowns(body, t);
      const unsigned int n_unknowns = components.n(), n_points = moments.size(),
                         n = n_unknowns * n_points;
      const std::vector<double> weights(n_points, 1.);
      FullMatrix<double>        stresses(components.m() * n_points, n);
      for (unsigned int p = 0; p < n_points; ++p)
        stresses.fill(components, components.m() * p, n_unknowns * p);

      ConicBlock block(n);
      add_yield_conditions(block,
                           stress_matrix<dim>(body.materials[t]),
                           stresses,
                           weights,
                           body.materials[t].yield_radius / body.stress_unit);
      if (body.has_friction() && body.friction_slopes[t] > 0.)
        {
          add_friction<dim>(block,
                            stresses,
                            weights,
                            /* pressures = */ std::vector<double>(n_points, 0.),
                            body.friction_slopes[t]);
          for (unsigned int p = 0; p < n_points; ++p)
            block.linear_cost[n_unknowns * p] = Tolerance::dilation_margin;
        }
      for (const auto &[number, velocity] : functions)
        {
          const auto     rates = components_of_rate(body, velocity, t, degree);
          Vector<double> power(n);
          for (unsigned int p = 0; p < n_points; ++p)
            for (unsigned int j = 0; j < n_unknowns; ++j)
              for (unsigned int c = 0; c < components.m(); ++c)
                power[n_unknowns * p + j] +=
                  moments[p] * (components(c, j) * rates[p][c]);
          block.add_to_equation(number, power);
        }
      return block;
    }



    /// Lets the indenter press downwards. A velocity, of this @p degree on
    /// faces, goes down with it if its coefficients in Bernstein's basis do. To
    /// each belongs a force; those at vertices and on edges are common to
    /// neighbours.
    template <int dim>
    void
    add_indenter(ConicProgram             &program,
                 const SplitBody<dim>     &body,
                 const VelocityBasis<dim> &basis,
                 const unsigned int        degree)
    {
      const auto &exponents_on_face = Bernstein<dim - 1>::exponents(degree);
      std::set<std::map<unsigned int, int>> pressed; // exponents of vertices
      for (const auto &view : views_of_faces(body))
        {
          if (!view.condition.is_reached)
            continue;
          const unsigned int        t         = view.face.neighbors[0];
          const auto               &functions = basis.on_simplices[t];
          std::vector<unsigned int> equations;
          FullMatrix<double>        upwards(exponents_on_face.size(),
                                     functions.size());
          for (const auto &[number, velocity] : functions)
            {
              const auto coefficients = Bernstein<dim - 1>::interpolate(
                degree, [&, &velocity = velocity](const auto &position) {
                  return velocity_at(body,
                                     velocity,
                                     t,
                                     view.point(position))[dim - 1];
                });
              for (unsigned int i = 0; i < upwards.m(); ++i)
                upwards(i, equations.size()) = coefficients[i];
              equations.push_back(number);
            }
          DissipationBlock block(equations.size());
          for (unsigned int i = 0; i < upwards.m(); ++i)
            {
              std::map<unsigned int, int> exponents;
              for (unsigned int j = 0; j < dim; ++j)
                if (const int e = exponents_on_face[i][j]; e > 0)
                  exponents[view.face.vertices[j]] = e;
              if (pressed.insert(exponents).second)
                block.add_condition(upwards,
                                    i,
                                    1.,
                                    body.indenter_velocity[dim - 1]);
            }
          if (!block.empty())
            program.blocks.push_back(block.make(equations));
        }
    }
  } // namespace



  // With friction, rates must be in the dual cones of the yield condition: what
  // they lack becomes smaller with the gap, on whatever mesh.
  template <int dim>
  VelocityField<dim>
  find_continuous_motion(const SplitBody<dim>      &body,
                         const double               tolerance,
                         const std::vector<double> &expected_multipliers)
  {
    const unsigned int       rate_degree = body.is_axisymmetric() ? 2 : 1;
    const VelocityBasis<dim> basis       = continuous_velocities(body);
    ConicProgram             program     = program_of_loads(body, basis);
    for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
      program.blocks.push_back(
        block_of_stresses(body, basis.on_simplices[t], t, rate_degree));
    add_indenter(program, body, basis, rate_degree + 1);
    program.expect_multipliers(expected_multipliers);
    const ConicSolution solution =
      minimize(std::move(program),
               body.has_friction() ?
                 Tolerance::part_with_friction *
                   std::min(tolerance, Tolerance::gap_of_bounds<dim>) :
                 tolerance);
    VelocityField<dim> field = field_of(body, basis, solution);
    field.is_optimal         = solution.relative_gap <= tolerance;
    return field;
  }



  template VelocityField<2>
  find_continuous_motion(const SplitBody<2> &,
                         const double,
                         const std::vector<double> &);
  template VelocityField<3>
  find_continuous_motion(const SplitBody<3> &,
                         const double,
                         const std::vector<double> &);
} // namespace ElastoPlastic
