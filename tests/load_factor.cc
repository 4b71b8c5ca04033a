// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Bounds of the factor of tractions and body forces that a perfectly plastic
// body bears, against exact values: on either side of them, whatever the mesh.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bounds/body/loads.h"
#include "bounds/limit_load.h"
#include "bounds/mechanism/velocity_check.h"
#include "bounds/stress/stress_check.h"
#include "output/columns.h"
#include "section_body.h"
#include "verdict.h"

using namespace ElastoPlastic;
using namespace SectionBody;

namespace
{
  const double k = 1. / std::sqrt(3.); // the yield stress is 1, or c cos(phi)

  const Gap nowhere = [](const Point<2> &) {
    return std::numeric_limits<double>::infinity();
  };



  struct Problem
  {
    Kinematics                kinematics;
    double                    inner_radius;
    std::string               tractions;
    std::string               body_force;
    std::vector<std::string>  free          = {};
    std::vector<std::string>  contact       = {}; ///< an anvil
    std::vector<std::string>  fixed         = {}; ///< the others are rollers
    std::vector<unsigned int> degrees       = {1, 2}; ///< of the stresses
    double                    friction_sine = 0.;
  };



  /// Between x = inner_radius and x = 2, y = -1 and y = 0.
  SplitBody<2>
  make_problem(const Problem &problem, const MeshKind kind)
  {
    Triangulation<2> mesh;
    make_rectangle(mesh, kind, 2, problem.inner_radius, 2., 1.);
    BoundaryConditionParameters parameters;
    parameters.traction = problem.tractions;
    parameters.free     = problem.free;
    parameters.contact  = problem.contact;
    parameters.fixed    = problem.fixed;
    for (const auto &[name, id] : names)
      if (problem.tractions.find(name) == std::string::npos &&
          std::count(problem.free.begin(), problem.free.end(), name) == 0 &&
          std::count(problem.contact.begin(), problem.contact.end(), name) ==
            0 &&
          std::count(problem.fixed.begin(), problem.fixed.end(), name) == 0)
        parameters.roller.push_back(name);
    const BoundaryConditions<2> conditions(parameters, names);
    const BodyForce<2>          body_force(problem.body_force);
    SplitMesh<2>                split_mesh = make_split_mesh(mesh);
    const Loads<2>              loads =
      Loads<2>::growing(split_mesh, conditions, body_force);
    auto body =
      make_split_body<2>(std::move(split_mesh),
                         conditions,
                         {material()},
                         {problem.contact.empty() ? nowhere : everywhere},
                         loads,
                         problem.kinematics);
    body.set_friction({problem.friction_sine});
    return body;
  }



  /// The bounds, relative to the @p exact factor, are between @p least and 1,
  /// and between 1 and @p most.
  void
  test(const std::string &title,
       const Problem     &problem,
       const double       exact,
       const double       least,
       const double       most)
  {
    for (const auto &[kind, name] : kinds)
      for (const unsigned int degree : problem.degrees)
        {
          const SplitBody<2> body   = make_problem(problem, kind);
          const LimitLoad<2> bounds = bound_limit_load(body, degree);
          output() << title << name << ", degree " << degree << std::endl;
          verify("below the exact factor",
                 bounds.lower_bound <= exact * (1. + 1e-9));
          verify("near to it", bounds.lower_bound >= least * exact);
          verify("admissible stress",
                 check_stress(body, bounds.stress).largest(),
                 1e-9);
          verify("above the exact factor",
                 bounds.upper_bound >= exact * (1. - 1e-9));
          verify("near to it", bounds.upper_bound <= most * exact);
          // (in a cone as far as the interior point method has come)
          verify("admissible velocity",
                 bounds.velocity.error,
                 body.has_friction() ? 1e-7 : 1e-9);
          verify("sum of the gaps",
                 std::abs(
                   std::accumulate(bounds.gaps.begin(), bounds.gaps.end(), 0.) /
                     power_of_loads(body, bounds.velocity.velocity).growing -
                   (bounds.upper_bound - bounds.lower_bound)),
                 1e-5);
        }
  }



  /// Soil with the friction of 30 degrees, on smooth ground.
  Problem
  soil(const std::string              &tractions,
       const std::string              &body_force,
       const std::vector<std::string> &free    = {},
       const std::vector<std::string> &contact = {},
       const std::vector<std::string> &fixed   = {})
  {
    return {Kinematics::cartesian,
            0.,
            tractions,
            body_force,
            free,
            contact,
            fixed,
            {1, 2},
            0.5};
  }



  void
  test_soil(const double exactly)
  {
    test("Soil in compression",
         soil("top: 0; -t", "", {"right"}),
         4. * k,
         1. - exactly,
         1. + exactly);
    test("Soil in compression under a constant pressure",
         soil("top: 0; -t | right: -0.3; 0", ""),
         4. * k + 3. * 0.3,
         1. - exactly,
         1. + exactly);
    test("Soil in tension between rollers",
         soil("top: 0; t", ""),
         2. * k,
         1. - exactly,
         1. + exactly);
    test("Soil drawn to the side under an anvil",
         soil("right: t; 0", "", {}, {"top"}),
         4. / 3. * k,
         1. - exactly,
         1. + exactly);
    // It falls as a whole, and the highest triangles stretch.
    test("Soil that hangs between rollers",
         soil("", "0; -t", {"bottom"}, {}, {"top"}),
         2. * k,
         1. - exactly,
         4. / 3. + exactly);
  }



  /// What limit_load.csv says of a load factor that need not be positive.
  void
  test_relative_difference()
  {
    LimitLoadRow row = {};
    row.upper_bound  = 1.;
    verify("no difference relative to zero",
           std::isnan(row.relative_difference()));
    row.lower_bound = -2.;
    row.upper_bound = -1.5;
    verify("a negative factor", row.relative_difference() == 0.25);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double exactly = 5e-5;
  test("Sheet in tension",
       {Kinematics::plane_stress, 0., "top: 0; t", "", {"right"}},
       1.,
       1. - exactly,
       1. + exactly);
  test("Slab in tension, all loads grow",
       {Kinematics::cartesian, 0., "top: 0; 0.01", "", {"right"}},
       200. * k,
       1. - exactly,
       1. + exactly);
  test("Slab in tension beside a constant pressure",
       {Kinematics::cartesian, 0., "top: 0; t | right: -0.3; 0", ""},
       2. * k - 0.3,
       1. - exactly,
       1. + exactly);
  test("Bar in tension under a constant pressure",
       {Kinematics::axisymmetric, 0., "top: 0; t | right: -0.3; 0", ""},
       1. - 0.3,
       1. - exactly,
       1. + exactly);
  // sigma_rr = 2 k ln(r / 2)
  test("Tube under pressure in plane strain",
       {Kinematics::axisymmetric, 1., "left: 2*t; 0 | right: 0; 0", ""},
       k * std::log(2.),
       0.93,
       1.02);
  // sigma_xy = t x, k at the wall
  test("Slab between rough walls under its weight",
       {Kinematics::cartesian,
        0.,
        "top: t*x; 0 | bottom: -t*x; 0",
        "0; -t",
        {},
        {},
        {"right"}},
       k / 2.,
       1. - exactly,
       1. + exactly);
  // sigma_rz = t r / 2, k at the wall; times r it is quadratic
  test("Cylinder in a rough pipe under its weight",
       {Kinematics::axisymmetric,
        0.,
        "top: t*x/2; 0 | bottom: -t*x/2; 0",
        "0; -t",
        {},
        {},
        {"right"},
        {2}},
       k,
       1. - exactly,
       1. + exactly);
  test("Slab between an anvil and the ground, drawn to the side",
       {Kinematics::cartesian, 0., "right: t; 0", "", {}, {"top"}},
       2. * k,
       1. - exactly,
       1. + exactly);
  test_soil(exactly);
  test_relative_difference();
}
