// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Bounds of limit loads of bodies of revolution whose material obeys Drucker
// and Prager's yield condition: a cylinder between smooth plates and under its
// own weight, and a tube under internal pressure, also with hardly any friction
// and with a layer without, whose limit loads are known; and circular footings.
// Velocities are strictly inside of their cones, and the gaps of the triangles
// add up to the difference of the bounds.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <limits>

#include "refine_where.h"
#include "soil_bounds.h"

using namespace ElastoPlastic;

namespace
{
  using Mesh = parallel::distributed::Triangulation<2>;

  /// Where the indenter can touch the top: up to this radius.
  IndenterOnBody<2>
  plate(const double radius, const SurfaceFinish surface)
  {
    return {[radius](const Point<2> &x) {
              return x[0] <= radius ? 0. :
                                      std::numeric_limits<double>::infinity();
            },
            surface};
  }

  const IndenterOnBody<2> nothing = plate(-1., SurfaceFinish::smooth);



  LimitLoad<2>
  checked_bounds(const Mesh                        &triangulation,
                 const BoundaryConditionParameters &parameters,
                 const IndenterOnBody<2>           &indenter,
                 const std::vector<double>         &angles,
                 const std::string                 &weight   = "0; 0",
                 const double                       rounding = 1e-12)
  {
    return SoilBounds::checked_bounds(
      SoilBounds::make_body(make_split_mesh(triangulation),
                            SectionBody::names,
                            parameters,
                            indenter,
                            angles,
                            Kinematics::axisymmetric,
                            weight),
      /* degree = */ 2,
      rounding);
  }

  void
  verify_limit(const LimitLoad<2> &bounds,
               const double        limit,
               const double        tolerance)
  {
    verify("lower bound",
           bounds.lower_bound <= limit * (1. + 1e-9) &&
             bounds.lower_bound >= limit * (1. - tolerance));
    verify("upper bound",
           bounds.upper_bound >= limit * (1. - 1e-9) &&
             bounds.upper_bound <= limit * (1. + tolerance));
  }



  /// Uniform stress and rate.
  void
  test_cylinder(const double degrees)
  {
    output() << "Cylinder, angle of friction " << degrees << std::endl;
    Mesh triangulation(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_rectangle(
      triangulation, {2, 2}, Point<2>(0, 0), Point<2>(1, 1), true);
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left", "bottom"};
    parameters.free    = {"right"};
    parameters.contact = {"top"};
    verify_limit(checked_bounds(triangulation,
                                parameters,
                                plate(1., SurfaceFinish::smooth),
                                {degrees}),
                 numbers::PI * SoilBounds::pressure_in_compression(degrees, 0.),
                 2e-6);
  }



  /// As a cylinder yields everywhere if the pressure on its side grows with the
  /// depth as slowly as its strength admits.
  void
  test_heavy_cylinder(const double degrees)
  {
    output() << "Cylinder under its weight, angle of friction " << degrees
             << std::endl;
    Mesh triangulation(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_rectangle(
      triangulation, {2, 2}, Point<2>(0, -1), Point<2>(1, 0), true);
    BoundaryConditionParameters parameters;
    parameters.roller   = {"left", "bottom"};
    parameters.free     = {"top"};
    const double weight = 10.;
    parameters.traction =
      "right: " +
      SoilBounds::traction_beside_heavy_ground(degrees, weight, "y") + "; 0";
    verify_limit(
      checked_bounds(triangulation, parameters, nothing, {degrees}, "0; -t"),
      weight,
      1e-5);
  }



  /// Between smooth plates, from the radius 1 to 2, under internal pressure. It
  /// flows in plane strain, where the cone bears as much as Mohr and Coulomb's:
  /// (p + T) / T = 2^(2 sin(phi) / (1 + sin(phi))), T = c cot(phi).
  void
  test_tube(const double       degrees,
            const unsigned int n_cells,
            const double       tolerance)
  {
    output() << "Tube, angle of friction " << degrees << std::endl;
    Mesh triangulation(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_rectangle(triangulation,
                                              {n_cells, 2},
                                              Point<2>(1, 0),
                                              Point<2>(2, 2.4 / n_cells),
                                              true);
    BoundaryConditionParameters parameters;
    parameters.roller   = {"bottom", "top"};
    parameters.free     = {"right"};
    parameters.traction = "left: t; 0";
    const double phi = degrees * numbers::PI / 180., sine = std::sin(phi);
    verify_limit(checked_bounds(triangulation, parameters, nothing, {degrees}),
                 (std::pow(2., 2. * sine / (1. + sine)) - 1.) / std::tan(phi),
                 tolerance);
  }



  /// A ring around a wide hole deforms as its section in plane strain: columns
  /// that bear 2 c and 2 c tan(45 degrees + phi / 2), and become as much
  /// shorter.
  void
  test_columns()
  {
    output() << "Columns without and with friction" << std::endl;
    constexpr double radius = 1e3;
    Mesh             triangulation(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_rectangle(triangulation,
                                              {2, 2},
                                              Point<2>(radius, 0),
                                              Point<2>(radius + 1., 1),
                                              true);
    for (const auto &cell : triangulation.active_cell_iterators())
      cell->set_material_id(cell->center()[0] < radius + 0.5 ? 0 : 1);
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left", "bottom"};
    parameters.free    = {"right"};
    parameters.contact = {"top"};
    const auto bounds =
      checked_bounds(triangulation,
                     parameters,
                     plate(2. * radius, SurfaceFinish::smooth),
                     {0., 20.},
                     "0; 0",
                     /* rounding = */ 1e-8);
    const double limit = 2. * numbers::PI * radius *
                         (1. + std::tan((45. + 10.) / 180. * numbers::PI));
    verify("lower bound", std::abs(bounds.lower_bound / limit - 1.), 2e-3);
    verify("upper bound", std::abs(bounds.upper_bound / limit - 1.), 2e-3);
  }



  /// A block with smaller cells at the edge of the footing, whose radius is 1.
  void
  make_ground(Mesh &triangulation)
  {
    GridGenerator::subdivided_hyper_rectangle(
      triangulation, {6, 6}, Point<2>(0, -6), Point<2>(6, 0), true);
    for (unsigned int k = 0; k < 3; ++k)
      refine_where(triangulation, [&](const auto &cell) {
        return cell->center().distance(Point<2>(1., 0.)) <
               2.5 * cell->diameter();
      });
  }



  LimitLoad<2>
  test_footing(const Mesh         &triangulation,
               const double        degrees,
               const SurfaceFinish surface,
               const std::string  &weight = "0; 0")
  {
    output() << "Footing, angle of friction " << degrees
             << (surface == SurfaceFinish::rough ? ", rough" : "")
             << (weight != "0; 0" ? ", weight" : "") << std::endl;
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left"};
    parameters.fixed   = {"bottom", "right"};
    parameters.contact = {"top"};
    return checked_bounds(
      triangulation, parameters, plate(1., surface), {degrees}, weight);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const double degrees : {10., 30.})
    {
      test_cylinder(degrees);
      test_heavy_cylinder(degrees);
    }
  // (What the divergence of polynomials exceeds that of the flow by costs c
  // cot(phi), which is large here; velocities that lose those without a change
  // of volume would be far too stiff.)
  test_tube(0.1, 24, 5e-3);
  for (const double degrees : {10., 30.})
    test_tube(degrees, 12, 1e-3);
  test_columns();

  Mesh triangulation(MPI_COMM_WORLD);
  make_ground(triangulation);
  const auto smooth  = SurfaceFinish::smooth;
  const auto without = test_footing(triangulation, 0., smooth);
  const auto hardly  = test_footing(triangulation, 0.1, smooth);
  verify("almost the stresses without friction",
         hardly.lower_bound > without.lower_bound &&
           hardly.lower_bound < 1.005 * without.lower_bound);
  verify("almost the mechanisms without friction",
         hardly.upper_bound < 1.06 * without.upper_bound);
  const auto weak   = test_footing(triangulation, 10., smooth);
  const auto strong = test_footing(triangulation, 30., smooth);
  for (const auto &bounds : {weak, strong})
    verify("bounds", bounds.upper_bound / bounds.lower_bound - 1., 0.08);
  const auto rough = test_footing(triangulation, 30., SurfaceFinish::rough);
  const auto heavy = test_footing(triangulation, 30., smooth, "0; -1");
  verify("more by friction", strong.lower_bound > weak.upper_bound);
  verify("more by roughness", rough.lower_bound > strong.upper_bound);
  verify("more by weight", heavy.lower_bound > strong.upper_bound);
}
