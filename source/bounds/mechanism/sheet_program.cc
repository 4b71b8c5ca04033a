// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

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
    using Functions = std::vector<VelocityFunction>;

    /// The integrals over a triangle of Bernstein's functions of the strain
    /// rate, in units of the body: positive.
    std::vector<double>
    moments_of_rate(const SplitBody<2> &body,
                    const unsigned int  t,
                    const unsigned int  degree)
    {
      const auto          corners = body.corners_of(t);
      std::vector<double> result(3, 1. / 3.);
      if (degree == 2)
        {
          std::array<double, 3> weights;
          for (unsigned int i = 0; i < 3; ++i)
            weights[i] = body.weight(corners[i]) / body.weight_unit();
          const auto of_quadratics = quadratic_moments(weights);
          result.assign(of_quadratics.begin(), of_quadratics.end());
        }
      for (double &moment : result)
        moment *= volume(corners) / body.length_unit;
      return result;
    }



    /// The coefficients in Bernstein's basis of a strain rate of this
    /// @p degree, by components: 11, 22, 2 e_12 and 33.
    std::vector<std::array<double, 4>>
    components_of_rate(const SplitBody<2>       &body,
                       const SimplexVelocity<2> &velocity,
                       const unsigned int        t,
                       const unsigned int        degree)
    {
      const auto                        &points = Bernstein<2>::points(degree);
      std::vector<std::array<double, 4>> result(points.size());
      for (unsigned int p = 0; p < points.size(); ++p)
        {
          const auto rate = strain_rate_at(body, velocity, t, points[p]);
          const std::array<double, 4> components = {
            {rate[0][0], rate[1][1], 2. * rate[0][1], rate[2][2]}};
          for (unsigned int a = 0; a < points.size(); ++a)
            for (unsigned int c = 0; c < components.size(); ++c)
              result[a][c] +=
                Bernstein<2>::coefficients(degree)(a, p) * components[c];
        }
      return result;
    }



    /// The dual of the minimisation, which reads: find stresses for the
    /// coefficients of the strain rate of the triangles, and forces q >= 0 of
    /// the indenter, in equilibrium in the sense of the principle of virtual
    /// power, with the largest sum of all q. Its Lagrange multipliers are the
    /// factors of the velocities, with the opposite sign.
    class ContinuousProgram
    {
    public:
      explicit ContinuousProgram(const SplitBody<2> &body);

      VelocityField<2>
      solve(const double tolerance) const;

    private:
      /// Adds the power of the tractions on a triangle, and of its body force.
      void
      add_tractions(const unsigned int triangle, const Functions &functions);
      void
      add_body_force(const unsigned int triangle, const Functions &functions);
      void
      add_block(const unsigned int triangle, const Functions &functions);
      /// To a block that begins with the yield conditions of these stresses.
      void
      add_friction_to(ConicBlock               &block,
                      const FullMatrix<double> &stresses,
                      const unsigned int        triangle) const;

      /// The power of a force of the indenter, which presses downwards, by
      /// functions.
      using ContactForce = std::vector<double>;

      /// Those of the triangle's sides, each vertex being counted once.
      std::vector<ContactForce>
      contact_forces(const unsigned int triangle, const Functions &functions);

      const SplitBody<2>                         &body;
      const std::unique_ptr<ContinuousVelocities> velocities;
      ConicProgram                                program;
      std::vector<bool>                           vertex_is_pressed;
    };



    ContinuousProgram::ContinuousProgram(const SplitBody<2> &body)
      : body(body)
      , velocities(make_continuous_velocities(body))
      , vertex_is_pressed(body.mesh.vertices.size(), false)
    {
      program.right_hand_side.reinit(velocities->n_functions());
      if (body.load_factor_unit > 0)
        program.live_load.reinit(velocities->n_functions());
      for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
        {
          const Functions functions = velocities->functions_of(t);
          add_tractions(t, functions);
          add_body_force(t, functions);
          add_block(t, functions);
        }
    }



    void
    ContinuousProgram::add_tractions(const unsigned int t,
                                     const Functions   &functions)
    {
      const double unit =
        body.stress_unit * body.length_unit * body.weight_unit();
      for (const unsigned int s : body.mesh.simplices[t].faces)
        for (const auto &component : body.conditions[s].components)
          {
            if (component.type != ConditionType::traction ||
                (component.value.is_zero() && component.live_load.is_zero()))
              continue;
            const FaceView<2> view(body, s);
            integrate_on_face<2>(
              view.corners,
              [&](const FacePoint<2> &point, const double weight) {
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
                    program.right_hand_side[number] += constant * along;
                    if (body.load_factor_unit > 0)
                      program.live_load[number] += growing * along;
                  }
              });
          }
    }



    void
    ContinuousProgram::add_body_force(const unsigned int t,
                                      const Functions   &functions)
    {
      if (body.body_force.norm() == 0. && body.live_body_force.norm() == 0.)
        return;
      const double size =
        volume(body.corners_of(t)) /
        (body.stress_unit * body.length_unit * body.weight_unit());
      for (const auto &[number, velocity] : functions)
        {
          Tensor<1, 2> mean;
          for (const auto &[point, weight] : simplex_quadrature<2>())
            mean += weight * weighted_velocity(body, velocity, t, point);
          program.right_hand_side[number] += size * (body.body_force * mean);
          if (body.load_factor_unit > 0)
            program.live_load[number] +=
              size * body.load_factor_unit * (body.live_body_force * mean);
        }
    }



    // A polynomial is 1 or more on a side if its coefficients in Bernstein's
    // basis are. To each belongs a force; those at the ends are common to
    // neighbours.
    std::vector<ContinuousProgram::ContactForce>
    ContinuousProgram::contact_forces(const unsigned int t,
                                      const Functions   &functions)
    {
      const auto &points = Bernstein<1>::points(velocities->trace_degree);
      const auto &coefficients =
        Bernstein<1>::coefficients(velocities->trace_degree);
      std::vector<ContactForce> forces;
      for (const unsigned int s : body.mesh.simplices[t].faces)
        {
          if (!body.conditions[s].is_reached)
            continue;
          const FaceView<2> view(body, s);
          for (unsigned int i = 0; i < points.size(); ++i)
            {
              if (i == 0 || i + 1 == points.size())
                {
                  const unsigned int vertex =
                    view.face.vertices[i == 0 ? 0 : 1];
                  if (vertex_is_pressed[vertex])
                    continue;
                  vertex_is_pressed[vertex] = true;
                }
              ContactForce &force = forces.emplace_back();
              for (const auto &[number, velocity] : functions)
                {
                  double coefficient = 0.;
                  for (unsigned int p = 0; p < points.size(); ++p)
                    coefficient +=
                      coefficients(i, p) *
                      velocity_at(body, velocity, t, view.point(points[p]))[1];
                  force.push_back(coefficient);
                }
            }
        }
      return forces;
    }



    // The stresses of a coefficient: 11, 22, 12, and in a body of revolution
    // 33, which in plane strain with friction is the mean of the first two.
    void
    ContinuousProgram::add_block(const unsigned int t,
                                 const Functions   &functions)
    {
      const auto moments = moments_of_rate(body, t, velocities->rate_degree);
      const auto forces  = contact_forces(t, functions);
      const unsigned int n_components = body.is_axisymmetric() ? 4 : 3,
                         n_stresses   = n_components * moments.size(),
                         n            = n_stresses + forces.size();
      FullMatrix<double> stresses(n_stress_components<2> * moments.size(), n);
      for (unsigned int p = 0; p < moments.size(); ++p)
        for (unsigned int c = 0; c < n_components; ++c)
          {
            const unsigned int row    = n_stress_components<2> * p,
                               column = n_components * p + c;
            stresses(row + c, column) = 1.;
            if (body.has_friction() && n_components == 3 && c < 2)
              stresses(row + 3, column) = 0.5;
          }

      ConicBlock &block = program.blocks.emplace_back(n);
      add_yield_conditions<2>(block,
                              stress_matrix<2>(body.materials[t]),
                              stresses,
                              std::vector<double>(moments.size(), 1.),
                              body.materials[t].yield_radius /
                                body.stress_unit);
      if (body.has_friction())
        add_friction_to(block, stresses, t);
      for (unsigned int f = 0; f < forces.size(); ++f)
        {
          block.linear_cost[n_stresses + f] = body.indenter_velocity[1];
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
          for (unsigned int p = 0; p < moments.size(); ++p)
            for (unsigned int c = 0; c < n_components; ++c)
              power[n_components * p + c] = moments[p] * rates[p][c];
          for (unsigned int f = 0; f < forces.size(); ++f)
            power[n_stresses + f] = forces[f][i];
          block.add_to_equation(functions[i].number, power);
        }
    }



    // The margin is that of the rate of volume: a cost of the mean stress.
    void
    ContinuousProgram::add_friction_to(ConicBlock               &block,
                                       const FullMatrix<double> &stresses,
                                       const unsigned int        t) const
    {
      const unsigned int n_points = stresses.m() / n_stress_components<2>;
      const double       slope    = body.friction_slopes[t];
      add_friction(block,
                   stresses,
                   std::vector<double>(n_points, 1.),
                   std::vector<double>(n_points, 0.),
                   slope);
      if (slope > 0.)
        for (unsigned int p = 0; p < n_points; ++p)
          for (const unsigned int c : {0, 1, 3})
            for (unsigned int j = 0; j < stresses.n(); ++j)
              block.linear_cost[j] +=
                2. / 3. * Tolerance::dilation_margin *
                stresses(n_stress_components<2> * p + c, j);
    }



    VelocityField<2>
    ContinuousProgram::solve(const double tolerance) const
    {
      // With friction, rates must be in the dual cones of the yield condition:
      // what they lack becomes smaller with the gap.
      const double        smaller  = body.has_friction() ?
                                       Tolerance::part_with_friction * tolerance :
                                       tolerance;
      const ConicSolution solution = minimize(program, smaller);

      VelocityField<2> field;
      for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
        {
          SimplexVelocity<2> &sum = field.velocity.emplace_back();
          for (const auto &[number, velocity] : velocities->functions_of(t))
            for (unsigned int i = 0; i < n_cubics; ++i)
              sum.coefficients[i] -=
                solution.y[number] * velocity.coefficients[i];
        }
      field.bound =
        -solution.cost *
        (body.load_factor_unit > 0 ? body.load_factor_unit : body.force_unit());
      field.n_iterations = solution.n_iterations;
      field.is_optimal   = solution.relative_gap <= tolerance;
      return field;
    }
  } // namespace



  VelocityField<2>
  find_motion_of_sheet(const SplitBody<2> &body, const double tolerance)
  {
    return ContinuousProgram(body).solve(tolerance);
  }
} // namespace ElastoPlastic
