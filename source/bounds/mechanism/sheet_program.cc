// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "bounds/body/yield_matrices.h"
#include "bounds/conic/interior_point.h"
#include "bounds/conic/tolerances.h"
#include "bounds/conic/yield_conditions.h"
#include "bounds/mechanism/quadratic_field.h"
#include "bounds/mechanism/velocity_program.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Stresses at the corners of a triangle: 11, 22, 12.
    constexpr unsigned int n_stresses = 9;

    constexpr unsigned int invalid = numbers::invalid_unsigned_int;



    /// The components of the velocity at a node, in two directions at right
    /// angles: the numbers of their equations, if they are not zero.
    struct Node
    {
      std::array<Tensor<1, 2>, 2> directions = {
        {Tensor<1, 2>({1., 0.}), Tensor<1, 2>({0., 1.})}};
      std::array<bool, 2>         fixed     = {};
      std::array<unsigned int, 2> equations = {{invalid, invalid}};

      /// No velocity in this direction.
      void
      fix(const Tensor<1, 2> &direction)
      {
        for (unsigned int c = 0; c < 2; ++c)
          if (std::abs(std::abs(directions[c] * direction) - 1.) <
              Tolerance::small_angle)
            {
              fixed[c] = true;
              return;
            }
        if (fixed[0] || fixed[1])
          fixed = {{true, true}};
        else
          {
            directions = {{direction, cross_product_2d(direction)}};
            fixed      = {{true, false}};
          }
      }
    };



    /// The dual of the minimisation, which reads: find stresses at the corners
    /// of the triangles, and forces q >= 0 of the indenter, in equilibrium in
    /// the sense of the principle of virtual power, with the largest sum of
    /// all q. Its Lagrange multipliers are the velocities, with the opposite
    /// sign.
    class QuadraticVelocityProgram
    {
    public:
      explicit QuadraticVelocityProgram(const SplitBody<2> &body);

      VelocityField<2>
      solve(const double tolerance) const;

    private:
      /// No velocity of a side in this direction.
      void
      fix(const unsigned int side, const Tensor<1, 2> &direction);
      void
      number_equations();
      void
      add_tractions();
      void
      add_body_force();
      void
      add_block(const unsigned int triangle);

      /// The nodes that a force of the indenter moves, with factors, downwards.
      using ContactForce = std::vector<std::pair<unsigned int, double>>;

      /// Those of the triangle's sides, each vertex being counted once.
      std::vector<ContactForce>
      contact_forces(const unsigned int triangle);
      SimplexVelocity<2>
      velocity_of(const unsigned int               triangle,
                  const std::vector<Tensor<1, 2>> &velocities) const;

      const SplitBody<2> &body;
      std::vector<Node>   nodes;
      ConicProgram        program;
      std::vector<bool>   vertex_is_pressed;
    };



    /// Of a triangle: its corners, then the middles of its sides.
    std::array<unsigned int, 6>
    nodes_of(const SplitMesh<2> &mesh, const unsigned int t)
    {
      const auto        &vertices = mesh.simplices[t].vertices;
      const auto        &sides    = mesh.simplices[t].faces;
      const unsigned int n        = mesh.vertices.size();
      return {{vertices[0],
               vertices[1],
               vertices[2],
               n + sides[0],
               n + sides[1],
               n + sides[2]}};
    }



    QuadraticVelocityProgram::QuadraticVelocityProgram(const SplitBody<2> &body)
      : body(body)
      , nodes(body.mesh.vertices.size() + body.mesh.faces.size())
      , vertex_is_pressed(body.mesh.vertices.size(), false)
    {
      number_equations();
      add_tractions();
      add_body_force();
      for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
        add_block(t);
    }



    void
    QuadraticVelocityProgram::fix(const unsigned int  s,
                                  const Tensor<1, 2> &direction)
    {
      for (const unsigned int vertex : body.mesh.faces[s].vertices)
        nodes[vertex].fix(direction);
      nodes[body.mesh.vertices.size() + s].fix(direction);
    }



    void
    QuadraticVelocityProgram::number_equations()
    {
      for (unsigned int s = 0; s < body.mesh.faces.size(); ++s)
        {
          for (const auto &component : body.conditions[s].components)
            if (component.type == ConditionType::displacement)
              fix(s, component.direction);
          if (body.conditions[s].is_reached &&
              body.indenter_surface == SurfaceFinish::rough)
            fix(s, Point<2>::unit_vector(0));
        }

      unsigned int n_equations = 0;
      for (Node &node : nodes)
        for (unsigned int c = 0; c < 2; ++c)
          if (!node.fixed[c])
            node.equations[c] = n_equations++;
      program.right_hand_side.reinit(n_equations);
      if (body.load_factor_unit > 0)
        program.live_load.reinit(n_equations);
    }



    // The power of the given tractions, for each of the three quadratic
    // functions of a side.
    void
    QuadraticVelocityProgram::add_tractions()
    {
      const double unit           = body.stress_unit * body.length_unit;
      const double live_load_unit = body.load_factor_unit / unit;
      for (unsigned int s = 0; s < body.mesh.faces.size(); ++s)
        for (const auto &component : body.conditions[s].components)
          {
            if (component.type != ConditionType::traction)
              continue;
            const auto        &side   = body.mesh.faces[s];
            const unsigned int middle = body.mesh.vertices.size() + s;
            const auto         add    = [&](Vector<double>    &loads,
                                 const unsigned int n,
                                 const double       force) {
              for (unsigned int c = 0; c < 2; ++c)
                if (!nodes[n].fixed[c])
                  loads[nodes[n].equations[c]] +=
                    force * (component.direction * nodes[n].directions[c]);
            };
            const auto add_all =
              [&](Vector<double> &loads, const double t, const double force) {
                add(loads, side.vertices[0], (1. - t) * (1. - 2. * t) * force);
                add(loads, side.vertices[1], t * (2. * t - 1.) * force);
                add(loads, middle, 4. * t * (1. - t) * force);
              };
            integrate_on_face<2>(
              body.mesh.corners(side),
              [&](const FacePoint<2> &point, const double weight) {
                const double t      = point.position[1];
                const double length = weight * area(body.mesh.corners(side));
                add_all(program.right_hand_side,
                        t,
                        length * component.value(point) / unit);
                if (body.load_factor_unit > 0)
                  add_all(program.live_load,
                          t,
                          length * live_load_unit * component.live_load(point));
              });
          }
    }



    // A third of that of a triangle acts at the middle of each of its sides: it
    // is the integral of the function of this node, and those of the corners
    // have none.
    void
    QuadraticVelocityProgram::add_body_force()
    {
      const double unit = body.stress_unit * body.length_unit;
      for (const auto &triangle : body.mesh.simplices)
        for (const unsigned int s : triangle.faces)
          {
            const Node  &node = nodes[body.mesh.vertices.size() + s];
            const double third =
              volume(body.mesh.corners(triangle)) / (3. * unit);
            for (unsigned int c = 0; c < 2; ++c)
              if (!node.fixed[c])
                {
                  const auto        &d = node.directions[c];
                  const unsigned int n = node.equations[c];
                  program.right_hand_side[n] += third * (body.body_force * d);
                  if (body.load_factor_unit > 0)
                    program.live_load[n] += third * body.load_factor_unit *
                                            (body.live_body_force * d);
                }
          }
    }



    // A quadratic function is 1 or more on a side if its three coefficients in
    // Bernstein's basis are: the values at the ends, a and b, and 2 m - (a + b)
    // / 2 with that in the middle, m. To each belongs a force.
    std::vector<QuadraticVelocityProgram::ContactForce>
    QuadraticVelocityProgram::contact_forces(const unsigned int t)
    {
      std::vector<ContactForce> forces;
      for (const unsigned int s : body.mesh.simplices[t].faces)
        {
          if (!body.conditions[s].is_reached)
            continue;
          const auto        &vertices = body.mesh.faces[s].vertices;
          const unsigned int middle   = body.mesh.vertices.size() + s;
          forces.push_back(
            {{middle, 2.}, {vertices[0], -0.5}, {vertices[1], -0.5}});
          for (const unsigned int vertex : vertices)
            if (!vertex_is_pressed[vertex])
              {
                vertex_is_pressed[vertex] = true;
                forces.push_back({{vertex, 1.}});
              }
        }
      return forces;
    }



    void
    QuadraticVelocityProgram::add_block(const unsigned int t)
    {
      const auto         forces = contact_forces(t);
      const unsigned int n      = n_stresses + forces.size();
      FullMatrix<double> stresses(3 * n_stress_components<2>, n);
      for (unsigned int corner = 0; corner < 3; ++corner)
        for (unsigned int c = 0; c < 3; ++c)
          stresses(n_stress_components<2> * corner + c, 3 * corner + c) = 1.;
      if (body.has_friction())
        for (unsigned int corner = 0; corner < 3; ++corner)
          for (unsigned int c = 0; c < 2; ++c)
            stresses(n_stress_components<2> * corner + 3, 3 * corner + c) = 0.5;

      ConicBlock &block = program.blocks.emplace_back(n);
      add_yield_conditions<2>(block,
                              stress_matrix<2>(body.materials[t]),
                              stresses,
                              {1., 1., 1.},
                              body.materials[t].yield_radius /
                                body.stress_unit);
      if (body.has_friction())
        add_friction(block, stresses, {0., 0., 0.}, body.friction_sines[t]);
      for (unsigned int f = 0; f < forces.size(); ++f)
        {
          block.linear_cost[n_stresses + f] = body.indenter_velocity[1];
          Vector<double> row(n);
          row[n_stresses + f] = -1.;
          block.add_inequality(row);
        }

      if (body.has_friction() && body.friction_sines[t] > 0.)
        for (unsigned int corner = 0; corner < 3; ++corner)
          for (unsigned int c = 0; c < 2; ++c)
            block.linear_cost[3 * corner + c] = Tolerance::dilation_margin;

      const auto   corners = body.mesh.corners(body.mesh.simplices[t]);
      const double weight  = volume(corners) / (3. * body.length_unit);
      std::array<std::array<Tensor<1, 2>, 6>, 3> gradients;
      for (unsigned int corner = 0; corner < 3; ++corner)
        gradients[corner] = shape_gradients<2>(corners, corner);

      unsigned int i = 0;
      for (const unsigned int node : nodes_of(body.mesh, t))
        {
          for (unsigned int c = 0; c < 2; ++c)
            if (!nodes[node].fixed[c])
              {
                const Tensor<1, 2> &d = nodes[node].directions[c];
                Vector<double>      power(n);
                for (unsigned int corner = 0; corner < 3; ++corner)
                  {
                    const Tensor<1, 2> g  = weight * gradients[corner][i];
                    power[3 * corner]     = d[0] * g[0];
                    power[3 * corner + 1] = d[1] * g[1];
                    power[3 * corner + 2] = d[0] * g[1] + d[1] * g[0];
                  }
                for (unsigned int f = 0; f < forces.size(); ++f)
                  for (const auto &[pressed, factor] : forces[f])
                    if (pressed == node)
                      power[n_stresses + f] += factor * d[1];
                block.add_to_equation(nodes[node].equations[c], power);
              }
          ++i;
        }
    }



    VelocityField<2>
    QuadraticVelocityProgram::solve(const double tolerance) const
    {
      // With friction, rates must be in the dual cones of the yield condition:
      // what they lack becomes smaller with the gap.
      const double        smaller  = body.has_friction() ?
                                       Tolerance::part_with_friction * tolerance :
                                       tolerance;
      const ConicSolution solution = minimize(program, smaller);

      std::vector<Tensor<1, 2>> velocities(nodes.size());
      for (unsigned int i = 0; i < nodes.size(); ++i)
        for (unsigned int c = 0; c < 2; ++c)
          if (!nodes[i].fixed[c])
            velocities[i] -=
              solution.y[nodes[i].equations[c]] * nodes[i].directions[c];

      VelocityField<2> field;
      for (unsigned int t = 0; t < body.mesh.simplices.size(); ++t)
        field.velocity.push_back(velocity_of(t, velocities));
      field.bound        = -solution.cost * (body.load_factor_unit > 0 ?
                                               body.load_factor_unit :
                                               body.stress_unit * body.length_unit);
      field.n_iterations = solution.n_iterations;
      field.is_optimal   = solution.relative_gap <= tolerance;
      return field;
    }



    SimplexVelocity<2>
    QuadraticVelocityProgram::velocity_of(
      const unsigned int t, const std::vector<Tensor<1, 2>> &velocities) const
    {
      const auto at_nodes = nodes_of(body.mesh, t);
      return interpolate_cubic([&](const Barycentric<2> &point) {
        Tensor<1, 2> value;
        for (unsigned int i = 0; i < 3; ++i)
          value +=
            point[i] * (2. * point[i] - 1.) * velocities[at_nodes[i]] +
            4. * point[i] * point[(i + 1) % 3] * velocities[at_nodes[3 + i]];
        return value;
      });
    }
  } // namespace



  VelocityField<2>
  find_motion_of_sheet(const SplitBody<2> &body, const double tolerance)
  {
    return QuadraticVelocityProgram(body).solve(tolerance);
  }
} // namespace ElastoPlastic
