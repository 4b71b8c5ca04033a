// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Bounds of the limit load of a strip footing on weightless soil, on both sides
// of Prandtl's N_c, of a smooth as of a rough footing, and of N_c + N_q, with a
// surcharge. Velocities are strictly inside of their cones.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "bounds/limit_load.h"
#include "bounds/stress/stress_check.h"
#include "refine_where.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  constexpr types::boundary_id beside = 4;

  /// The ground beside the footing is a boundary of its own.
  void
  divide_surface(Triangulation<2> &coarse_mesh)
  {
    for (const auto &cell : coarse_mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == 3 &&
            face->center()[0] > 1.)
          face->set_boundary_id(beside);
  }



  /// The right half of the ground, with smaller cells at the edge of the
  /// footing of half-width 1.
  void
  make_mesh(parallel::distributed::Triangulation<2> &triangulation,
            const unsigned int                       n,
            const unsigned int                       n_refinements)
  {
    GridGenerator::subdivided_hyper_rectangle(triangulation,
                                              {2 * n, n},
                                              Point<2>(0, -1. * n),
                                              Point<2>(2. * n, 0),
                                              /* colorize = */ true);
    divide_surface(triangulation);
    for (unsigned int k = 0; k < n_refinements; ++k)
      refine_where(triangulation, [&](const auto &cell) {
        return cell->center().distance(Point<2>(1., 0.)) <
               2.5 * cell->diameter();
      });
  }



  BoundaryConditions<2>
  boundary_conditions(const std::string &traction)
  {
    BoundaryConditionParameters parameters;
    parameters.roller   = {"left", "right"};
    parameters.fixed    = {"bottom"};
    parameters.contact  = {"top"};
    parameters.traction = traction;
    return {parameters,
            {{"left", 0},
             {"right", 1},
             {"bottom", 2},
             {"top", 3},
             {"beside", beside}}};
  }



  SplitBody<2>
  footing(const SplitMesh<2> &mesh,
          const double        sine,
          const SurfaceFinish surface,
          const double        surcharge)
  {
    Material<double> material;
    material.bulk_modulus      = 800.;
    material.shear_modulus     = 400.;
    material.yield_radius      = std::sqrt(2. * (1. - sine * sine));
    material.isotropic_modulus = 0.;
    const auto gap             = [](const Point<2> &x) {
      return x[0] <= 1. ? 0. : std::numeric_limits<double>::infinity();
    };
    auto body =
      make_split_body<2>(mesh,
                         boundary_conditions("beside: 0; " +
                                             std::to_string(-surcharge)),
                         {material},
                         {gap, surface},
                         0.);
    body.set_friction({sine});
    return body;
  }



  void
  test_footing(const SplitMesh<2> &mesh,
               const double        degrees,
               const SurfaceFinish surface,
               const double        surcharge = 0.)
  {
    const double phi = degrees * numbers::PI / 180., sine = std::sin(phi);
    const double n_q =
      std::exp(numbers::PI * std::tan(phi)) * (1. + sine) / (1. - sine);
    const double       limit  = (n_q - 1.) / std::tan(phi) + surcharge * n_q;
    const SplitBody<2> body   = footing(mesh, sine, surface, surcharge);
    const auto         bounds = bound_limit_load(body, /* degree = */ 1);
    output() << "Angle of friction " << degrees
             << (surface == SurfaceFinish::rough ? ", rough" : "")
             << (surcharge > 0. ? ", surcharge" : "") << std::endl;
    verify("lower bound",
           bounds.lower_bound <= limit && bounds.lower_bound > 0.95 * limit);
    verify("upper bound",
           bounds.upper_bound >= limit && bounds.upper_bound < 1.05 * limit);
    verify("admissible stress",
           check_stress(body, bounds.stress).largest(),
           1e-9);
    verify("admissible velocity", bounds.velocity.error, 1e-12);
    verify("gaps",
           std::all_of(bounds.gaps.begin(),
                       bounds.gaps.end(),
                       [](const double gap) { return gap > -1e-6; }));
    verify("sum of the gaps",
           std::abs(
             std::accumulate(bounds.gaps.begin(), bounds.gaps.end(), 0.) -
             (bounds.upper_bound - bounds.lower_bound)),
           1e-5);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize        mpi(argc, argv, 1);
  parallel::distributed::Triangulation<2> triangulation(MPI_COMM_WORLD);
  make_mesh(triangulation, 8, 4);
  const SplitMesh<2> mesh = make_split_mesh(triangulation);
  test_footing(mesh, 10., SurfaceFinish::rough);
  test_footing(mesh, 20., SurfaceFinish::smooth);
  test_footing(mesh, 30., SurfaceFinish::rough);
  test_footing(mesh, 30., SurfaceFinish::smooth, /* surcharge = */ 2.);
}
