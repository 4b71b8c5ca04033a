// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The interior point method on small programs with known solutions.

#include <deal.II/base/mpi.h>

#include <cmath>

#include "bounds/conic/interior_point.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// x in the ball of this @p radius; no cost, no equations.
  ConicBlock
  ball(const unsigned int n, const double radius)
  {
    ConicBlock block(n);
    block.cone_sizes  = {n + 1};
    block.cone_scales = {ConeScale()};
    block.cone_matrix.reinit(n + 1, n);
    block.cone_offset.reinit(n + 1);
    block.cone_offset[0] = radius;
    for (unsigned int i = 0; i < n; ++i)
      block.cone_matrix(i + 1, i) = -1.;
    return block;
  }



  // x_1 = 1.2 leaves a circle of radius 1.6 in the other two.
  void
  test_linear_cost()
  {
    ConicProgram program;
    program.blocks                   = {ball(3, 2.)};
    program.blocks[0].linear_cost[0] = 3.;
    program.blocks[0].linear_cost[2] = 4.;
    Vector<double> row(3);
    row[1] = 1.;
    program.blocks[0].add_to_equation(0, row);
    program.right_hand_side.reinit(1);
    program.right_hand_side[0] = 1.2;

    const ConicSolution solution = minimize(program, 1e-13);
    output() << "Linear cost" << std::endl;
    verify("cost", std::abs(solution.cost + 8.), 1e-8);
    verify("x_0", std::abs(solution.x[0] + 0.96), 1e-6);
    verify("x_1", std::abs(solution.x[1] - 1.2), 1e-12);
    verify("x_2", std::abs(solution.x[2] + 1.28), 1e-6);
    // d cost / d b = -y: the radius r shrinks, d(-5 r) / db = 5 b / r
    verify("multiplier", std::abs(solution.y[0] + 3.75), 1e-5);
  }



  // Minimise 1/2 |x|^2 + 1/2 |y|^2 with x_0 + y_0 = 2, x_1 + y_1 = 3 (a dense
  // row), x in the ball of radius 1, and y_0 >= 2: x = (0, 1), y = (2, 2).
  void
  test_quadratic_cost()
  {
    ConicProgram program;
    program.blocks = {ball(2, 1.), ConicBlock(2)};
    Vector<double> row(2);
    for (ConicBlock &block : program.blocks)
      block.quadratic_cost.reinit(2, 2);
    for (ConicBlock &block : program.blocks)
      for (unsigned int i = 0; i < 2; ++i)
        {
          block.quadratic_cost(i, i) = 1.;
          row                        = 0.;
          row[i]                     = 1.;
          block.add_to_equation(i, row);
        }
    row    = 0.;
    row[0] = -1.;
    program.blocks[1].add_inequality(row);
    program.blocks[1].cone_offset[0] = -2.;
    program.right_hand_side.reinit(2);
    program.right_hand_side[0] = 2.;
    program.right_hand_side[1] = 3.;
    program.has_dense_row      = true;

    const ConicSolution solution = minimize(program, 1e-10);
    output() << "Quadratic cost" << std::endl;
    verify("cost", std::abs(solution.cost - 4.5), 1e-10);
    verify("x", std::abs(solution.x[0]) + std::abs(solution.x[1] - 1.), 1e-6);
    verify("y",
           std::abs(solution.x[2] - 2.) + std::abs(solution.x[3] - 2.),
           1e-6);
    verify("multiplier", std::abs(solution.y[1] + 2.), 1e-6);
    verify("few iterations", solution.n_iterations < 20);
  }



  // Maximise lambda with x_0 = 2 lambda and x_1 = 1.2 in the ball of radius 2:
  // 2 lambda = sqrt(4 - x_1^2).
  void
  test_load_factor()
  {
    ConicProgram program;
    program.blocks = {ball(3, 2.)};
    Vector<double> row(3);
    for (unsigned int i = 0; i < 2; ++i)
      {
        row    = 0.;
        row[i] = 1.;
        program.blocks[0].add_to_equation(i, row);
      }
    program.right_hand_side.reinit(2);
    program.right_hand_side[1] = 1.2;
    program.live_load.reinit(2);
    program.live_load[0] = 2.;

    const ConicSolution solution = minimize(program, 1e-12);
    output() << "Load factor" << std::endl;
    verify("load factor", std::abs(solution.load_factor - 0.8), 1e-9);
    verify("cost", std::abs(solution.cost + 0.8), 1e-9);
    verify("x",
           std::abs(solution.x[0] - 1.6) + std::abs(solution.x[1] - 1.2) +
             std::abs(solution.x[2]),
           1e-6);
    // d cost / d b = -y
    verify("multipliers",
           std::abs(solution.y[0] + 0.5) + std::abs(solution.y[1] + 0.375),
           1e-5);

    program.right_hand_side[1] = 2.2;
    print_error("No load factor", [&]() { minimize(program, 1e-9); });
  }



  // A chain of bars that carry the same force lambda = x_0 and each a shear
  // x_1 = 0.6 R, where R is the radius of its ball: the weakest bears 0.8. They
  // are strong by very different amounts, and no rounding is as small as the
  // tolerance. What the iteration has reached must be admissible to the last
  // digits: then it bounds the solution from below.
  void
  test_early_end()
  {
    const std::vector<double> radii = {1e5, 1., 1e3, 1.0001, 1e7, 1e2};
    ConicProgram              program;
    program.right_hand_side.reinit(2 * radii.size());
    program.live_load.reinit(2 * radii.size());
    for (unsigned int b = 0; b < radii.size(); ++b)
      {
        program.blocks.push_back(ball(3, radii[b]));
        Vector<double> row(3);
        row[1] = 1.;
        program.blocks[b].add_to_equation(2 * b, row);
        program.right_hand_side[2 * b] = 0.6 * radii[b];
        row                            = 0.;
        row[0]                         = 1.;
        program.blocks[b].add_to_equation(2 * b + 1, row);
        if (b > 0)
          {
            row[0] = -1.;
            program.blocks[b - 1].add_to_equation(2 * b + 1, row);
          }
      }
    program.live_load[1] = 1.;

    const ConicSolution solution = minimize(program, 1e-30);
    output() << "Early end" << std::endl;
    verify("not optimal", !solution.is_optimal);
    verify("load factor", std::abs(solution.load_factor - 0.8), 1e-6);
    verify("lower bound", solution.load_factor - 0.8, 1e-14);
    double outside = 0, unbalanced = 0;
    for (unsigned int b = 0; b < radii.size(); ++b)
      {
        const double *const x = solution.x.begin() + 3 * b;
        outside =
          std::max(outside, std::hypot(x[0], x[1], x[2]) / radii[b] - 1.);
        unbalanced = std::max({unbalanced,
                               std::abs(x[0] - solution.load_factor),
                               std::abs(x[1] - 0.6 * radii[b]) / radii[b]});
      }
    verify("in the balls", outside, 1e-14);
    verify("equations", unbalanced, 1e-13);
  }



  // 1/2 |x|^2 with x_0 + x_1 = 2
  void
  test_no_cones()
  {
    ConicProgram program;
    program.blocks.emplace_back(2);
    program.blocks[0].quadratic_cost.reinit(2, 2);
    Vector<double> row(2);
    for (unsigned int i = 0; i < 2; ++i)
      {
        program.blocks[0].quadratic_cost(i, i) = 1.;
        row[i]                                 = 1.;
      }
    program.blocks[0].add_to_equation(0, row);
    program.right_hand_side.reinit(1);
    program.right_hand_side[0] = 2.;

    const ConicSolution solution = minimize(program, 1e-9);
    output() << "No cones" << std::endl;
    verify("cost", std::abs(solution.cost - 1.), 1e-12);
    verify("x_0", std::abs(solution.x[0] - 1.), 1e-12);
    verify("x_1", std::abs(solution.x[1] - 1.), 1e-12);
    verify("multiplier", std::abs(solution.y[0] + 1.), 1e-12);
  }



  void
  test_no_solution()
  {
    ConicProgram program;
    program.blocks = {ball(2, 1.)};
    Vector<double> row(2);
    row[0] = 1.;
    program.blocks[0].add_to_equation(0, row);
    program.right_hand_side.reinit(1);
    program.right_hand_side[0] = 1.1;
    print_error("Outside the ball", [&]() { minimize(program, 1e-9); });
  }



  // -2 x_0 - x_1, x >= 0, x_0 = x_1
  void
  test_unbounded()
  {
    ConicProgram program;
    program.blocks.emplace_back(2);
    Vector<double> row(2);
    for (unsigned int i = 0; i < 2; ++i)
      {
        row    = 0.;
        row[i] = -1.;
        program.blocks[0].add_inequality(row);
      }
    program.blocks[0].linear_cost[0] = -2.;
    program.blocks[0].linear_cost[1] = -1.;
    row[0]                           = 1.;
    program.blocks[0].add_to_equation(0, row);
    program.right_hand_side.reinit(1);
    print_error("Along a ray", [&]() { minimize(program, 1e-9); });
  }



  // Of the first blocks; the others and those of which nothing is expected get
  // a part of the mean.
  void
  test_expected_multipliers()
  {
    ConicProgram program;
    program.blocks = {ball(2, 1.), ball(2, 1.), ball(2, 1.)};
    output() << "Expected multipliers" << std::endl;
    program.expect_multipliers({});
    verify("nothing known", program.expected_multipliers.empty());
    program.expect_multipliers({0., 0.});
    verify("nothing expected", program.expected_multipliers.empty());
    program.expect_multipliers({-1e-9, 6e-3});
    const auto &expected = program.expected_multipliers;
    verify("all blocks", expected.size() == 3);
    verify("what is negative is zero", expected[0] == expected[2]);
    verify("positive", expected[2] > 1e-3 && expected[2] < 6e-2);
    verify("added", std::abs(expected[1] - expected[2] - 6e-3), 1e-15);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_linear_cost();
  test_quadratic_cost();
  test_load_factor();
  test_early_end();
  test_no_cones();
  test_expected_multipliers();
  test_no_solution();
  test_unbounded();
}
