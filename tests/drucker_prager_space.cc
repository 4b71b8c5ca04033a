// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Bounds of limit loads in space of material that obeys Drucker and Prager's
// yield condition: exact ones of a cube in triaxial compression and extension,
// on a distorted mesh with hanging nodes, also under its own weight, and where
// it stands at an angle to the axes, and of columns with and without friction
// side by side; and those of footings. Velocities are strictly inside of their
// cones, and the gaps of the tetrahedra add up to the difference of the bounds.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "box_names.h"
#include "refine_where.h"
#include "soil_bounds.h"

using namespace ElastoPlastic;

namespace
{
  using Mesh = parallel::distributed::Triangulation<3>;
  using Gap  = std::function<double(const Point<3> &)>;

  const Gap everywhere = [](const Point<3> &) {
    return 0.;
  };
  const Gap nowhere = [](const Point<3> &) {
    return std::numeric_limits<double>::infinity();
  };
  const Gap footing = [](const Point<3> &x) {
    return std::max(x[0], x[1]) <= 1. ? 0. :
                                        std::numeric_limits<double>::infinity();
  };



  /// Tractions grow where there is no indenter.
  LimitLoad<3>
  checked_bounds(const Mesh                        &triangulation,
                 const BoundaryConditionParameters &parameters,
                 const IndenterOnBody<3>           &indenter,
                 const std::vector<double>         &angles,
                 const std::string                 &weight = "0; 0; 0")
  {
    return SoilBounds::checked_bounds(
      SoilBounds::make_body(make_split_mesh(triangulation),
                            names_of_box,
                            parameters,
                            indenter,
                            angles,
                            Kinematics::cartesian,
                            weight),
      /* degree = */ 1);
  }



  void
  verify_exact(const LimitLoad<3> &bounds, const double exact)
  {
    verify("lower bound",
           bounds.lower_bound <= exact * (1. + 1e-9) &&
             bounds.lower_bound >= exact * (1. - 2e-5));
    verify("upper bound",
           bounds.upper_bound >= exact * (1. - 1e-9) &&
             bounds.upper_bound <= exact * (1. + 2e-5));
  }



  /// The pressure that the sides of a cube bear beside the pressure @p q on its
  /// ends: the deviator is sqrt(2/3) (p - q), the mean -(2 p + q) / 3.
  double
  in_extension(const double degrees, const double q)
  {
    const auto [radius, slope] = SoilBounds::soil(degrees).drucker_prager(0);
    const double a = std::sqrt(2. / 3.), b = std::sqrt(2.) * slope / 3.;
    return (radius + q * (a + b)) / (a - 2. * b);
  }



  void
  test_cube(const Mesh &cube, const double degrees)
  {
    output() << "Compression, angle of friction " << degrees << std::endl;
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left", "front", "bottom"};
    parameters.free    = {"right", "back"};
    parameters.contact = {"top"};
    verify_exact(checked_bounds(cube, parameters, {everywhere}, {degrees}),
                 SoilBounds::pressure_in_compression(degrees, 0.));

    output() << "with a pressure on the sides" << std::endl;
    parameters.free     = {};
    parameters.traction = "right: -0.7; 0; 0 | back: 0; -0.7; 0";
    verify_exact(checked_bounds(cube, parameters, {everywhere}, {degrees}),
                 SoilBounds::pressure_in_compression(degrees, 0.7));

    output() << "Extension" << std::endl;
    parameters.contact  = {};
    parameters.free     = {"top"};
    parameters.traction = "right: -t; 0; 0 | back: 0; -t; 0";
    verify_exact(checked_bounds(cube, parameters, {nowhere}, {degrees}),
                 in_extension(degrees, 0.));

    output() << "with a pressure on the top" << std::endl;
    parameters.free = {};
    parameters.traction += " | top: 0; 0; -0.7";
    verify_exact(checked_bounds(cube, parameters, {nowhere}, {degrees}),
                 in_extension(degrees, 0.7));
  }



  /// Rollers are at an angle to the axes.
  void
  test_turned_cube(Mesh &cube)
  {
    output() << "Turned by 25 degrees" << std::endl;
    GridTools::rotate(Tensor<1, 3>({0., 0., 1.}),
                      25. / 180. * numbers::PI,
                      cube);
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left", "front", "bottom"};
    parameters.free    = {"right", "back"};
    parameters.contact = {"top"};
    verify_exact(checked_bounds(cube, parameters, {everywhere}, {30.}),
                 SoilBounds::pressure_in_compression(30., 0.));
  }



  /// It yields everywhere if the pressure on its sides grows with the depth as
  /// slowly as its strength admits. The gaps know the pressure of the weight.
  void
  test_weight(const Mesh &cube)
  {
    output() << "Under a weight that grows" << std::endl;
    BoundaryConditionParameters parameters;
    parameters.roller   = {"left", "front", "bottom"};
    parameters.free     = {"top"};
    const double weight = 10.;
    const auto   beside =
      SoilBounds::traction_beside_heavy_ground(10., weight, "z");
    parameters.traction =
      "right: " + beside + "; 0; 0 | back: 0; " + beside + "; 0";
    verify_exact(checked_bounds(cube, parameters, {nowhere}, {10.}, "0; 0; -t"),
                 weight);
  }



  /// In plane strain, columns that bear 2 c and 2 c tan(45 degrees + phi / 2)
  /// become as much shorter.
  void
  test_columns()
  {
    output() << "Columns without and with friction" << std::endl;
    Mesh columns(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_rectangle(
      columns, {2, 1, 2}, Point<3>(0, 0, -1), Point<3>(1, 1, 0), true);
    for (const auto &cell : columns.active_cell_iterators())
      cell->set_material_id(cell->center()[0] < 0.5 ? 0 : 1);
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left", "front", "back", "bottom"};
    parameters.free    = {"right"};
    parameters.contact = {"top"};
    verify_exact(checked_bounds(columns, parameters, {everywhere}, {0., 20.}),
                 1. + std::tan(numbers::PI * (45. + 10.) / 180.));
  }



  LimitLoad<3>
  test_footing(const Mesh         &block,
               const SurfaceFinish surface,
               const std::string  &weight)
  {
    output() << (surface == SurfaceFinish::rough ? "Rough" : "Smooth")
             << " footing under the weight " << weight << std::endl;
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left", "front"};
    parameters.fixed   = {"bottom", "right", "back"};
    parameters.contact = {"top"};
    return checked_bounds(block, parameters, {footing, surface}, {20.}, weight);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Mesh cube(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(
    cube, {2, 2, 2}, Point<3>(0, 0, -1), Point<3>(1, 1, 0), true);
  GridTools::distort_random(0.2, cube, /* keep_boundary = */ true);
  refine_where(cube, [&](const auto &cell) {
    return cell->center().distance(Point<3>(1, 1, 0)) < 0.6;
  });
  for (const double degrees : {10., 30.})
    test_cube(cube, degrees);
  test_weight(cube);
  test_turned_cube(cube);
  test_columns();

  Mesh block(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(
    block, {2, 2, 2}, Point<3>(0, 0, -2), Point<3>(2, 2, 0), true);
  const std::string none = "0; 0; 0", weight = "0; 0; -2";
  const auto        heavy  = test_footing(block, SurfaceFinish::rough, weight);
  const auto        alone  = test_footing(block, SurfaceFinish::rough, none);
  const auto        smooth = test_footing(block, SurfaceFinish::smooth, none);
  const auto is_more = [](const LimitLoad<3> &more, const LimitLoad<3> &less) {
    return more.lower_bound > less.lower_bound &&
           more.upper_bound > less.upper_bound;
  };
  verify("more by weight", is_more(heavy, alone));
  verify("more by roughness", is_more(alone, smooth));
}
