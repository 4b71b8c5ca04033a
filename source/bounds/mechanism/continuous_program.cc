// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "bounds/body/yield_matrices.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/tolerances.h"
#include "bounds/conic/yield_conditions.h"
#include "bounds/mechanism/continuous_velocities.h"
#include "bounds/mechanism/face_view.h"
#include "bounds/mechanism/velocity_program.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    using Functions = std::vector<VelocityFunction<dim>>;

    /// The integrals over a simplex of Bernstein's functions of the strain
    /// rate, in units of the body: positive.
    template <int dim>
    std::vector<double>
    moments_of_rate(const SplitBody<dim> &body,
                    const unsigned int    t,
                    const unsigned int    degree)
    {
      const auto          corners = body.corners_of(t);
      const unsigned int  n       = Bernstein<dim>::n_functions(degree);
      std::vector<double> result(n, 1. / n);
      if constexpr (dim == 2)
        if (degree == 2)
          {
            std::array<double, 3> weights;
            for (unsigned int i = 0; i < 3; ++i)
              weights[i] = body.weight(corners[i]) / body.weight_unit();
            const auto of_quadratics = quadratic_moments(weights);
            result.assign(of_quadratics.begin(), of_quadratics.end());
          }
      for (double &moment : result)
        moment *= volume(corners) / std::pow(body.length_unit, dim - 1);
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

      const auto &points = Bernstein<dim>::points(degree);
      std::vector<std::array<double, n>> result(points.size());
      for (unsigned int p = 0; p < points.size(); ++p)
        {
          const auto rate = strain_rate_at(body, velocity, t, points[p]);
          for (unsigned int c = 0; c < n; ++c)
            {
              const double component = stress_from<dim>(&units(c, 0)) * rate;
              for (unsigned int a = 0; a < points.size(); ++a)
                result[a][c] +=
                  Bernstein<dim>::coefficients(degree)(a, p) * component;
            }
        }
      return result;
    }



    /// The dual of the minimisation, which reads: find stresses for the
    /// coefficients of the strain rate of the triangles, and forces q >= 0 of
    /// the indenter, in equilibrium in the sense of the principle of virtual
    /// power, with the largest sum of all q. Its Lagrange multipliers are the
    /// factors of the velocities, with the opposite sign.
    template <int dim>
    class ContinuousProgram
    {
    public:
      explicit ContinuousProgram(const SplitBody<dim> &body);

      VelocityField<dim>
      solve(const double tolerance) const;

    private:
      /// Adds the power of the tractions on a simplex, and of its body force.
      void
      add_tractions(const unsigned int    simplex,
                    const Functions<dim> &functions);
      void
      add_body_force(const unsigned int    simplex,
                     const Functions<dim> &functions);
      void
      add_block(const unsigned int simplex, const Functions<dim> &functions);
      /// The stress components of a coefficient by its unknowns.
      FullMatrix<double>
      components_of_unknowns(const unsigned int simplex) const;

      /// The power of a force of the indenter, which presses downwards, by
      /// functions.
      using ContactForce = std::vector<double>;

      /// Those of the simplex' faces, each coefficient being counted once.
      std::vector<ContactForce>
      contact_forces(const unsigned int    simplex,
                     const Functions<dim> &functions);

      const SplitBody<dim>                            &body;
      const std::unique_ptr<ContinuousVelocities<dim>> velocities;
      ConicProgram                                     program;

      /// The coefficients that have a force, by the exponents of vertices.
      std::set<std::map<unsigned int, int>> pressed;
    };



    template <int dim>
    ContinuousProgram<dim>::ContinuousProgram(const SplitBody<dim> &body)
      : body(body)
      , velocities(make_continuous_velocities(body))
    {
      program.set_equations(velocities->n_functions(),
                            body.load_factor_unit > 0);
      for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
        {
          const Functions<dim> functions = velocities->functions_of(t);
          add_tractions(t, functions);
          add_body_force(t, functions);
          add_block(t, functions);
        }
    }



    template <int dim>
    void
    ContinuousProgram<dim>::add_tractions(const unsigned int    t,
                                          const Functions<dim> &functions)
    {
      const double unit = body.stress_unit * body.weight_unit() *
                          std::pow(body.length_unit, dim - 1);
      for (const unsigned int s : body.mesh.simplices[t].faces)
        for (const auto &component : body.conditions[s].components)
          {
            if (component.type != ConditionType::traction ||
                (component.value.is_zero() && component.live_load.is_zero()))
              continue;
            const FaceView<dim> view(body, s);
            integrate_on_face<dim>(
              view.corners,
              [&](const FacePoint<dim> &point, const double weight) {
                const double constant = component.value(point) / unit,
                             growing  = body.load_factor_unit *
                                       component.live_load(point) / unit;
                for (const auto &[number, velocity] : functions)
                  {
                    const double along =
                      weight * view.area *
                      (weighted_velocity(
                         body, velocity, t, view.point(point.position)) *
                       component.direction);
                    program.add_load(number, constant * along, growing * along);
                  }
              });
          }
    }



    template <int dim>
    void
    ContinuousProgram<dim>::add_body_force(const unsigned int    t,
                                           const Functions<dim> &functions)
    {
      if (body.body_force.norm() == 0. && body.live_body_force.norm() == 0.)
        return;
      const double size =
        volume(body.corners_of(t)) / (body.stress_unit * body.weight_unit() *
                                      std::pow(body.length_unit, dim - 1));
      for (const auto &[number, velocity] : functions)
        {
          Tensor<1, dim> mean;
          for (const auto &[point, weight] : simplex_quadrature<dim>())
            mean += weight * weighted_velocity(body, velocity, t, point);
          program.add_load(number,
                           size * (body.body_force * mean),
                           size * body.load_factor_unit *
                             (body.live_body_force * mean));
        }
    }



    // A polynomial is 1 or more on a face if its coefficients in Bernstein's
    // basis are. To each belongs a force; those at vertices and on edges are
    // common to neighbours.
    template <int dim>
    std::vector<typename ContinuousProgram<dim>::ContactForce>
    ContinuousProgram<dim>::contact_forces(const unsigned int    t,
                                           const Functions<dim> &functions)
    {
      const unsigned int degree = velocities->trace_degree;
      const auto        &points = Bernstein<dim - 1>::points(degree);
      const auto &coefficients  = Bernstein<dim - 1>::coefficients(degree);
      std::vector<ContactForce> forces;
      for (const unsigned int s : body.mesh.simplices[t].faces)
        {
          if (!body.conditions[s].is_reached)
            continue;
          const FaceView<dim> view(body, s);
          for (unsigned int i = 0; i < points.size(); ++i)
            {
              std::map<unsigned int, int> exponents;
              for (unsigned int j = 0; j < dim; ++j)
                if (const int e = Bernstein<dim - 1>::exponents(degree)[i][j];
                    e > 0)
                  exponents[view.face.vertices[j]] = e;
              if (!pressed.insert(exponents).second)
                continue;
              ContactForce &force = forces.emplace_back();
              for (const auto &[number, velocity] : functions)
                {
                  double coefficient = 0.;
                  for (unsigned int p = 0; p < points.size(); ++p)
                    coefficient += coefficients(i, p) *
                                   velocity_at(body,
                                               velocity,
                                               t,
                                               view.point(points[p]))[dim - 1];
                  force.push_back(coefficient);
                }
            }
        }
      return forces;
    }



    // Without friction, the components: of a sheet, 11, 22 and 12. With it, the
    // first unknown is the slope times the mean stress, others are deviators.
    // So the yield condition and the power, moments of rate of volume over
    // slope, are of the same size for any slope, and so are rounding errors. In
    // plane strain the mean is 33, too.
    template <int dim>
    FullMatrix<double>
    ContinuousProgram<dim>::components_of_unknowns(const unsigned int t) const
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
    template <int dim>
    void
    ContinuousProgram<dim>::add_block(const unsigned int    t,
                                      const Functions<dim> &functions)
    {
      const auto moments    = moments_of_rate(body, t, velocities->rate_degree);
      const auto forces     = contact_forces(t, functions);
      const auto components = components_of_unknowns(t);
      const unsigned int n_unknowns = components.n(), n_points = moments.size(),
                         n_stresses = n_unknowns * n_points,
                         n          = n_stresses + forces.size();
      const std::vector<double> weights(n_points, 1.);
      FullMatrix<double>        stresses(components.m() * n_points, n);
      for (unsigned int p = 0; p < n_points; ++p)
        stresses.fill(components, components.m() * p, n_unknowns * p);

      ConicBlock &block = program.blocks.emplace_back(n);
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
      for (unsigned int f = 0; f < forces.size(); ++f)
        {
          block.linear_cost[n_stresses + f] = body.indenter_velocity[dim - 1];
          Vector<double> row(n);
          row[n_stresses + f] = -1.;
          block.add_inequality(row);
        }

      for (unsigned int i = 0; i < functions.size(); ++i)
        {
          const auto     rates = components_of_rate(body,
                                                functions[i].velocity,
                                                t,
                                                velocities->rate_degree);
          Vector<double> power(n);
          for (unsigned int p = 0; p < n_points; ++p)
            for (unsigned int j = 0; j < n_unknowns; ++j)
              for (unsigned int c = 0; c < components.m(); ++c)
                power[n_unknowns * p + j] +=
                  moments[p] * (components(c, j) * rates[p][c]);
          for (unsigned int f = 0; f < forces.size(); ++f)
            power[n_stresses + f] = forces[f][i];
          block.add_to_equation(functions[i].number, power);
        }
    }



    template <int dim>
    VelocityField<dim>
    ContinuousProgram<dim>::solve(const double tolerance) const
    {
      // With friction, rates must be in the dual cones of the yield condition:
      // what they lack becomes smaller with the gap, on whatever mesh.
      const double smaller =
        body.has_friction() ?
          Tolerance::part_with_friction *
            std::min(tolerance, Tolerance::gap_of_bounds<dim>) :
          tolerance;
      const ConicSolution solution = minimize(program, smaller);

      VelocityField<dim> field = field_of(body, solution);
      field.is_optimal         = solution.relative_gap <= tolerance;
      for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
        {
          SimplexVelocity<dim> &sum = field.velocity.emplace_back();
          for (const auto &[number, velocity] : velocities->functions_of(t))
            sum.add(-solution.y[number], velocity);
        }
      return field;
    }
  } // namespace



  template <int dim>
  VelocityField<dim>
  find_continuous_motion(const SplitBody<dim> &body, const double tolerance)
  {
    return ContinuousProgram<dim>(body).solve(tolerance);
  }



  template VelocityField<2>
  find_continuous_motion(const SplitBody<2> &, const double);
  template VelocityField<3>
  find_continuous_motion(const SplitBody<3> &, const double);
} // namespace ElastoPlastic
