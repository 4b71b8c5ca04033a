// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// A solver that fails, by an exception or by using up its iterations, is
// replaced by another for good, with one warning.

#include "material/material_parameters.h"
#include "solver/fallback_solver.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// Returns the numbers of iterations given to it, one for each solve; throws
  /// instead of returning 0.
  class FakeSolver : public TangentSolver<2>
  {
  public:
    FakeSolver(const std::string               &name,
               const std::vector<unsigned int> &results)
      : name(name)
      , results(results)
    {}

    void
    prepare(const SolidOperator<2> &, const VectorType &held) override
    {
      output() << "  " << name << " is prepared, " << held.l1_norm() << " held"
               << std::endl;
    }

    unsigned int
    solve(VectorType &, const VectorType &, const double) override
    {
      const unsigned int n = results.at(n_solves++);
      output() << "  " << name << " solves" << std::endl;
      if (n == 0)
        throw ConvergenceError("not finite");
      return n;
    }

  private:
    const std::string               name;
    const std::vector<unsigned int> results;
    unsigned int                    n_solves = 0;
  };



  void
  check(const std::string &title, const std::vector<unsigned int> &results)
  {
    output() << title << std::endl;
    const auto         solid = make_solid_operator<2>(1,
                                              VolumetricTreatment::standard,
                                              MaterialParameters().materials());
    VectorType         held(3), solution(3), rhs(3);
    const unsigned int maximum_iterations = 10;
    held(1)                               = 1.;

    FallbackSolver<2> solver(
      std::make_unique<FakeSolver>("fast", results),
      maximum_iterations,
      []() {
        return std::make_unique<FakeSolver>("slow",
                                            std::vector<unsigned int>{7, 8});
      },
      [](const std::string &warning) {
        output() << "  warning: " << warning << std::endl;
      });
    for (unsigned int i = 0; i < 2; ++i)
      {
        solver.prepare(*solid, held);
        const unsigned int n = solver.solve(solution, rhs, 1e-8);
        output() << "  iterations: " << n << std::endl;
      }
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check("No failure", {3, 9});
  check("Too many iterations", {10});
  check("Values that are not finite", {3, 0});
}
