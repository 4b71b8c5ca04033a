// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Bounds of the factor of tractions and body forces in space, against exact
// values.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/body/loads.h"
#include "bounds/limit_load.h"
#include "bounds/stress/stress_check.h"
#include "box_names.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  const double k = 1. / std::sqrt(3.); // the yield stress is 1

  struct Problem
  {
    std::string              tractions;
    std::string              body_force;
    std::vector<std::string> free;
    std::vector<std::string> fixed; ///< the others are rollers
  };



  /// A cube of edge length 2, with a corner in the origin, of eight cells.
  SplitBody<3>
  make_problem(const Problem &problem)
  {
    parallel::distributed::Triangulation<3> mesh(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_cube(
      mesh, 2, 0., 2., /* colorize = */ true);

    BoundaryConditionParameters parameters;
    parameters.traction = problem.tractions;
    parameters.free     = problem.free;
    parameters.fixed    = problem.fixed;
    const auto is_in    = [](const std::vector<std::string> &list,
                          const std::string              &name) {
      return std::count(list.begin(), list.end(), name) > 0;
    };
    for (const auto &[name, id] : names_of_box)
      if (problem.tractions.find(name) == std::string::npos &&
          !is_in(problem.free, name) && !is_in(problem.fixed, name))
        parameters.roller.push_back(name);

    Material<double> material;
    material.bulk_modulus      = 800.;
    material.shear_modulus     = 400.;
    material.yield_radius      = std::sqrt(2. / 3.);
    material.isotropic_modulus = 0.;

    const BoundaryConditions<3> conditions(parameters, names_of_box);
    const BodyForce<3>          body_force(problem.body_force);
    SplitMesh<3>                tetrahedra = make_split_mesh(mesh);
    const Loads<3>              loads =
      Loads<3>::growing(tetrahedra, conditions, body_force);
    return make_split_body<3>(std::move(tetrahedra),
                              conditions,
                              {material},
                              {[](const Point<3> &) {
                                return std::numeric_limits<double>::infinity();
                              }},
                              loads);
  }



  void
  test(const std::string &title, const Problem &problem, const double exact)
  {
    constexpr double near = 1e-4;

    const SplitBody<3> body   = make_problem(problem);
    const LimitLoad<3> bounds = bound_limit_load(body, 1);
    output() << title << std::endl;
    verify("below the exact factor", bounds.lower_bound <= exact * (1. + 1e-9));
    verify("near to it", bounds.lower_bound >= exact * (1. - near));
    verify("admissible stress",
           check_stress(body, bounds.stress).largest(),
           1e-9);
    verify("above the exact factor", bounds.upper_bound >= exact * (1. - 1e-9));
    verify("near to it", bounds.upper_bound <= exact * (1. + near));
    verify("admissible velocity", bounds.velocity.error, 1e-9);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  test("Bar in tension, all loads grow",
       {"top: 0; 0; 0.01", "", {"right", "back"}, {}},
       100.);
  test("Bar in tension under a constant pressure",
       {"top: 0; 0; t | right: -0.3; 0; 0 | back: 0; -0.3; 0", "", {}, {}},
       1. - 0.3);
  // sigma_xz = t x, k at the wall
  test("Slab between rough walls under its weight",
       {"top: t*x; 0; 0 | bottom: -t*x; 0; 0", "0; 0; -t", {}, {"right"}},
       k / 2.);
}
