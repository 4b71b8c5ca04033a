// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Stresses in exact equilibrium and mechanisms of collapse under a flat strip
// punch: admissible whatever the mesh, and on both sides of the exact limit
// load (2 + pi) k, of a smooth as of a rough punch.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "bounds/limit_load.h"
#include "bounds/stress/stress_check.h"
#include "bounds/stress/stress_field.h"
#include "refine_where.h"
#include "verdict.h"

#include <omp.h>

using namespace ElastoPlastic;

namespace
{
  const double exact = 2. + numbers::PI; // k = 1



  Material<double>
  material()
  {
    Material<double> material;
    material.bulk_modulus      = 800.;
    material.shear_modulus     = 400.;
    material.yield_radius      = std::sqrt(2.);
    material.isotropic_modulus = 0.;
    return material;
  }



  /// The right half of a block of half-width 10, with smaller cells at the edge
  /// of the punch.
  void
  make_mesh(parallel::distributed::Triangulation<2> &triangulation)
  {
    GridGenerator::subdivided_hyper_rectangle(triangulation,
                                              {10, 10},
                                              Point<2>(0, -10),
                                              Point<2>(10, 0),
                                              /* colorize = */ true);
    for (unsigned int k = 0; k < 2; ++k)
      refine_where(triangulation, [&](const auto &cell) {
        return cell->center().distance(Point<2>(1., 0.)) <
               1.5 * cell->diameter();
      });
  }



  BoundaryConditions<2>
  boundary_conditions()
  {
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left"};
    parameters.free    = {"right"};
    parameters.fixed   = {"bottom"};
    parameters.contact = {"top"};
    return {parameters, {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}}};
  }



  void
  test_mesh(const SplitMesh<2> &mesh)
  {
    double       sum              = 0;
    bool         all_positive     = true;
    unsigned int n_boundary_sides = 0;
    for (const auto &triangle : mesh.simplices)
      {
        const double size = volume(mesh.corners(triangle));
        all_positive      = all_positive && size > 0;
        sum += size;
      }
    for (const auto &side : mesh.faces)
      if (side.boundary_id != numbers::internal_face_boundary_id)
        ++n_boundary_sides;
    output() << "Mesh" << std::endl;
    verify("area", std::abs(sum - 100.), 1e-10);
    verify("orientation", all_positive);
    // three sides of each triangle, two triangles at each side inside
    verify("conforming",
           3 * mesh.simplices.size() ==
             2 * mesh.faces.size() - n_boundary_sides);
  }



  /// @return the lower bound.
  double
  test_bounds(const SplitBody<2> &body, const unsigned int degree)
  {
    const LimitLoad<2> bounds = bound_limit_load(body, degree);
    const double lower = bounds.stress.force, upper = bounds.velocity.bound;
    output() << (body.kinematics == Kinematics::plane_stress ? "Plane stress" :
                                                               "Plane strain")
             << (body.indenter_surface == SurfaceFinish::rough ? ", rough" : "")
             << ", degree " << degree << std::endl;
    if (body.kinematics != Kinematics::plane_stress)
      {
        verify("lower bound", lower <= exact && lower > 0.96 * exact);
        verify("upper bound", upper >= exact && upper < 1.02 * exact);
        verify("admissible velocity", bounds.velocity.error, 1e-9);
      }
    verify("order", lower <= upper);
    verify("admissible stress",
           check_stress(body, bounds.stress).largest(),
           1e-10);
    verify("gaps",
           *std::min_element(bounds.gaps.begin(), bounds.gaps.end()) > -1e-9);
    verify("sum of the gaps",
           std::accumulate(bounds.gaps.begin(), bounds.gaps.end(), 0.) <
             upper - lower + 1e-6);
    return lower;
  }



  // The linear stresses are among the quadratic ones.
  void
  test_degrees(const SplitBody<2> &body)
  {
    const double first = test_bounds(body, 1), second = test_bounds(body, 2);
    verify("closer than the first degree",
           body.kinematics == Kinematics::plane_stress ?
             second > first :
             exact - second < 0.6 * (exact - first));
  }



  // Both programs at the same time.
  void
  test_threads(const SplitBody<2> &body)
  {
    omp_set_num_threads(1);
    const LimitLoad<2> one = bound_limit_load(body, 1);
    omp_set_num_threads(3);
    const LimitLoad<2> three = bound_limit_load(body, 1);
    output() << "Side by side" << std::endl;
    verify("three threads remain", omp_get_max_threads() == 3);
    omp_set_num_threads(1);
    verify("the same lower bound", one.lower_bound == three.lower_bound);
    verify("the same upper bound", one.upper_bound == three.upper_bound);
    verify("the same gaps", one.gaps == three.gaps);
  }



  // What a coarser mesh has shown makes the way shorter, and leads to the same
  // bounds.
  void
  test_expectation(const SplitBody<2> &body,
                   const LimitLoad<2> &coarser,
                   const SplitMesh<2> &coarser_mesh)
  {
    const LimitLoad<2> cold = bound_limit_load(body, 1),
                       warm =
                         bound_limit_load(body,
                                          1,
                                          Tolerance::gap_of_bounds<2>,
                                          expected_multipliers(coarser,
                                                               coarser_mesh,
                                                               body.mesh));
    output() << "With the bounds of a coarser mesh" << std::endl;
    verify("the same lower bound",
           std::abs(warm.lower_bound / cold.lower_bound - 1.),
           2e-6);
    verify("the same upper bound",
           std::abs(warm.upper_bound / cold.upper_bound - 1.),
           2e-6);
    verify("fewer iterations for stresses",
           warm.stress.n_iterations < 0.9 * cold.stress.n_iterations);
    verify("fewer iterations for velocities",
           warm.velocity.n_iterations < 0.9 * cold.velocity.n_iterations);
    verify("optimal", warm.stress.is_optimal && warm.velocity.is_optimal);
    verify("admissible stress",
           check_stress(body, warm.stress).largest(),
           1e-10);
    verify("admissible velocity", warm.velocity.error, 1e-9);
  }



  // Force and depth control are two ways to the same stresses, elastic-plastic
  // and hardening.
  void
  test_hencky(SplitBody<2> body, const double hardening)
  {
    for (Material<double> &of_triangle : body.materials)
      of_triangle.isotropic_modulus = hardening;
    const StressField<2> by_force = equilibrate_with_force(body, 0.8 * exact);
    const StressField<2> by_depth =
      equilibrate_with_depth(body, by_force.depth);
    output() << "Hencky, hardening " << hardening << std::endl;
    verify("force", std::abs(by_force.force / (0.8 * exact) - 1.), 1e-9);
    verify("the same depth",
           std::abs(by_depth.force / by_force.force - 1.),
           1e-5);
    // J(F) - depth F is what depth control minimises
    verify("the same energy",
           std::abs((by_force.cost - by_force.depth * by_force.force) /
                      by_depth.cost -
                    1.),
           1e-8);
    verify("admissible stress", check_stress(body, by_force).largest(), 1e-9);
    if (hardening > 0)
      {
        for (Material<double> &of_triangle : body.materials)
          of_triangle.isotropic_modulus = 0.;
        verify("yields", check_stress(body, by_force).yield_excess > 0.1);
      }
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize        mpi(argc, argv, 1);
  parallel::distributed::Triangulation<2> triangulation(MPI_COMM_WORLD);
  make_mesh(triangulation);
  const auto conditions = boundary_conditions();
  const auto gap        = [](const Point<2> &x) {
    return x[0] <= 1. ? 0. : std::numeric_limits<double>::infinity();
  };
  const SplitMesh<2> mesh = make_split_mesh(triangulation);

  test_mesh(mesh);
  const auto body_with = [&](const Kinematics    kinematics,
                             const SurfaceFinish surface =
                               SurfaceFinish::smooth) {
    return make_split_body<2>(
      mesh, conditions, {material()}, {gap, surface}, 0., kinematics);
  };
  for (const SurfaceFinish surface :
       {SurfaceFinish::smooth, SurfaceFinish::rough})
    {
      test_degrees(body_with(Kinematics::cartesian, surface));
      test_degrees(body_with(Kinematics::plane_stress, surface));
    }
  test_threads(body_with(Kinematics::cartesian));
  const SplitBody<2> coarser = body_with(Kinematics::cartesian);
  const LimitLoad<2> bounds  = bound_limit_load(coarser, 1);
  triangulation.refine_global(1);
  test_expectation(make_split_body<2>(make_split_mesh(triangulation),
                                      conditions,
                                      {material()},
                                      {gap, SurfaceFinish::smooth},
                                      0.,
                                      Kinematics::cartesian),
                   bounds,
                   coarser.mesh);
  test_hencky(body_with(Kinematics::cartesian), 0.);
  test_hencky(body_with(Kinematics::cartesian), 10.);
  test_hencky(body_with(Kinematics::plane_stress), 10.);
}
