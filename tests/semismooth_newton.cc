// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The semi-smooth Newton method on small problems without any mesh: networks
// of nonlinear springs over an obstacle.

#include <deal.II/base/mpi.h>

#include "solver/semismooth_newton.h"
#include "spring_network.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Vector = SemismoothNewton::Vector;

  /// n masses in a row, held by springs between them and to walls at both
  /// ends, pulled towards an obstacle.
  SpringNetwork
  chain(const unsigned int n, const SpringLaw &law)
  {
    FullMatrix<double>  springs(n + 1, n);
    std::vector<double> bound(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        springs(i, i)     = 1.;
        springs(i + 1, i) = -1.;
        const double x    = (i + 1.) / (n + 1.);
        bound[i]          = 1. + 40. * (x - 0.4) * (x - 0.4);
      }
    return SpringNetwork(springs,
                         law,
                         std::vector<double>(n, 0.2),
                         bound,
                         std::vector<bool>(n, false));
  }



  NewtonReport
  solve(ConstrainedMinimization &problem,
        Vector                  &u,
        const unsigned int       iterations = 100)
  {
    NewtonParameters parameters;
    parameters.tolerance          = 1e-12;
    parameters.maximum_iterations = iterations;
    const SemismoothNewton newton(parameters, [](const NewtonStep &) {});
    return newton.solve(problem, u);
  }



  /// Whether residuals fall quadratically once the active set has settled.
  bool
  converges_quadratically(const NewtonReport &report)
  {
    unsigned int n_quadratic = 0;
    for (unsigned int k = 1; k < report.steps.size(); ++k)
      {
        const NewtonStep &last = report.steps[k - 1], &step = report.steps[k];
        if (last.residual < 0.1 && !step.active_set_changed &&
            last.residual > 1e-12)
          {
            ++n_quadratic;
            if (step.residual > 20 * last.residual * last.residual + 1e-14)
              return false;
          }
      }
    return n_quadratic >= 2;
  }



  void
  check_chain(const std::string &name, const SpringLaw &law)
  {
    SpringNetwork problem = chain(20, law);
    Vector        u(20);
    const auto    report = solve(problem, u);
    output() << name
             << " springs over an obstacle\n  one of the free masses at "
             << u[15] << ", " << problem.n_active() << " masses in contact"
             << std::endl;
    verify("  optimality", problem.optimality_error(u), 1e-11);
    verify("  at most 15 iterations", report.n_iterations() <= 15);
    verify("  as many linear systems as iterations",
           report.n_linear_iterations() == report.n_iterations());
  }



  void
  check_quadratic_convergence()
  {
    SpringNetwork problem = chain(20, stiffening);
    Vector        u(20);
    verify("residuals fall quadratically",
           converges_quadratically(solve(problem, u)));
  }



  /// One softening spring.
  SpringNetwork
  softening_spring()
  {
    FullMatrix<double> spring(1, 1);
    spring(0, 0) = 1.;
    return SpringNetwork(spring,
                         softening,
                         {0.1},
                         {std::numeric_limits<double>::infinity()},
                         {false});
  }



  /// Far from equilibrium.
  void
  check_line_search()
  {
    SpringNetwork problem = softening_spring();
    Vector        u(1);
    u[0]                 = 3.;
    const auto report    = solve(problem, u);
    bool       shortened = false, descends = true;
    for (unsigned int k = 1; k < report.steps.size(); ++k)
      {
        shortened = shortened || report.steps[k].step_length < 1.;
        descends  = descends && report.steps[k].energy <=
                                 report.steps[k - 1].energy * (1. + 1e-14);
      }
    output() << "softening spring, where full steps diverge\n  mass at " << u[0]
             << std::endl;
    verify("  optimality", problem.optimality_error(u), 1e-11);
    verify("  steps were shortened", shortened);
    verify("  the energy never grows", descends);
    verify("  ends with full steps", report.steps.back().step_length == 1.);
  }



  /// A quadratic problem on which the primal-dual active set method cycles
  /// through the sets {1}, {0, 1, 2}, {2}. It is the one of Curtis, Han and
  /// Robinson, doi:10.1007/s10589-014-9681-9.
  SpringNetwork
  cycling_problem()
  {
    FullMatrix<double> matrix(3), factor(3), springs(3);
    const double       entries[] = {4, 5, -5, 5, 9, -5, -5, -5, 7};
    matrix.fill(entries);
    factor.cholesky(matrix);
    springs.copy_transposed(factor);
    return SpringNetwork(
      springs, linear, {-2, -1, 3}, {0, 0, 0}, {false, false, false});
  }



  void
  check_cycling()
  {
    SpringNetwork problem = cycling_problem();
    Vector        u(3);
    const auto    report = solve(problem, u);
    output() << "active set that cycles\n  solution " << u[0] << ' ' << u[1]
             << ' ' << u[2] << std::endl;
    verify("  optimality", problem.optimality_error(u), 1e-11);
    verify("  the feasible method has taken over",
           report.steps.back().feasible && !report.steps.front().feasible);
    verify("  at most 30 iterations", report.n_iterations() <= 30);
  }



  /// The norm of the residual in place of the energy.
  void
  check_without_energy()
  {
    output() << "without an energy" << std::endl;
    for (const SpringLaw &law : {linear, stiffening, softening})
      {
        SpringNetworkWithoutEnergy problem(chain(20, law));
        Vector                     u(20);
        const auto                 report = solve(problem, u);
        verify("  optimality", problem.optimality_error(u), 1e-11);
        verify("  at most 15 iterations", report.n_iterations() <= 15);
      }

    SpringNetworkWithoutEnergy spring(softening_spring());
    Vector                     u(1);
    u[0]              = 3.;
    const auto report = solve(spring, u);
    bool       falls  = true;
    for (unsigned int k = 1; k < report.steps.size(); ++k)
      falls = falls && report.steps[k].step_length > 0. &&
              report.steps[k].step_length <= 1.;
    verify("  a spring where full steps diverge",
           spring.optimality_error(u),
           1e-11);
    verify("  steps were shortened", falls && report.steps[1].step_length < 1.);

    SpringNetworkWithoutEnergy cycling(cycling_problem());
    Vector                     v(3);
    try
      {
        solve(cycling, v);
        verify("  an active set that cycles is an error", false);
      }
    catch (const ConvergenceError &error)
      {
        verify("  an active set that cycles is an error that says why",
               std::string(error.what()).find("makes no progress") !=
                 std::string::npos);
      }
  }



  /// n masses in a row at the end of a spring, at the other end of which there
  /// is a wall; the springs between them are far stiffer; they are pulled.
  SpringNetwork
  row(const unsigned int n, const double stiffness, const SpringLaw &law)
  {
    FullMatrix<double> springs(n, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        springs(i, i) = (i == 0 ? 1. : std::sqrt(stiffness));
        if (i > 0)
          springs(i, i - 1) = -springs(i, i);
      }
    return SpringNetwork(
      springs,
      law,
      std::vector<double>(n, 0.3),
      std::vector<double>(n, std::numeric_limits<double>::infinity()),
      std::vector<bool>(n, false));
  }



  /// A displacement of 0.9 has its last digit at 1e-16, which is a force of
  /// 1e-7 between stiff masses.
  void
  check_rounding()
  {
    for (const double stiffness : {1., 1e9})
      {
        SpringNetwork problem = row(3, stiffness, linear);
        Vector        u(3);
        const auto    report   = solve(problem, u);
        const double  residual = report.steps.back().residual;
        output() << "springs with the stiffness " << stiffness
                 << " between masses\n  displacement " << u[2] << std::endl;
        verify("  displacement", std::abs(u[2] - 0.9 - 0.9 / stiffness), 1e-14);
        verify("  at most 10 iterations", report.n_iterations() <= 10);
        verify("  forces as small as the tolerance, if they can be",
               stiffness == 1. ? residual <= 1e-12 :
                                 residual > 1e-12 && residual < 1e-6);
      }
  }



  /// At the solution the springs have stored what the loads have done, so that
  /// the energy is no measure of its own rounding errors.
  void
  check_vanishing_energy()
  {
    SpringNetwork free_row = row(20, 1., stiffening);
    Vector        u(20);
    const double  energy = solve(free_row, u).steps.back().energy;
    SpringLaw     law    = stiffening;
    law.energy           = [energy](const double e) {
      return stiffening.energy(e) - energy / 20.;
    };
    SpringNetwork problem = row(20, 1., law);
    u                     = 0.;
    const auto report     = solve(problem, u);
    verify("an energy that vanishes at the solution",
           std::abs(report.steps.back().energy),
           1e-12 * std::abs(energy));
    verify("  at most 15 iterations", report.n_iterations() <= 15);
    verify("  ends with full steps", report.steps.back().step_length == 1.);
  }



  void
  check_limit()
  {
    SpringNetwork problem = chain(20, stiffening);
    Vector        u(20);
    try
      {
        solve(problem, u, 1);
        verify("a limit of one iteration is an error", false);
      }
    catch (const ConvergenceError &error)
      {
        verify("a limit of one iteration is an error that names the entry",
               std::string(error.what())
                   .find("'Nonlinear solver/Maximum number of iterations'") !=
                 std::string::npos);
      }
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_chain("linear", linear);
  check_chain("stiffening", stiffening);
  check_chain("softening", softening);
  check_quadratic_convergence();
  check_line_search();
  check_cycling();
  check_without_energy();
  check_rounding();
  check_vanishing_energy();
  check_limit();
}
