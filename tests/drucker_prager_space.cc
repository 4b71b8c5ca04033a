// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Bounds of limit loads in space of material that obeys Drucker and Prager's
// yield condition: exact ones of a cube in triaxial compression and extension,
// on a distorted mesh with hanging nodes, also where it stands at an angle to
// the axes, and those of a cube and of a footing with weight. Velocities are
// strictly inside of their cones, and the gaps of the tetrahedra add up to the
// difference of the bounds.

#include <deal.II/base/mpi.h>
#include <deal.II/base/patterns.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "box_names.h"
#include "soil_bounds.h"

using namespace ElastoPlastic;
using SoilBounds::strength;

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



  /// Materials with these angles of friction, by material id. Tractions grow
  /// where there is no indenter.
  SplitBody<3>
  make_body(const Mesh                        &triangulation,
            const BoundaryConditionParameters &parameters,
            const IndenterOnBody<3>           &indenter,
            const std::vector<double>         &angles,
            const std::string                 &force = "0; 0; 0")
  {
    std::vector<Material<double>> materials;
    std::vector<double>           slopes;
    for (const double degrees : angles)
      {
        const auto [radius, slope] = strength(degrees);
        Material<double> &material = materials.emplace_back();
        material.bulk_modulus      = 800.;
        material.shear_modulus     = 400.;
        material.yield_radius      = radius;
        material.isotropic_modulus = 0.;
        slopes.push_back(slope);
      }
    const BoundaryConditions<3> conditions(parameters, names_of_box);
    const BodyForce<3>          body_force(force);
    SplitMesh<3>                mesh  = make_split_mesh(triangulation);
    const Loads<3>              loads = parameters.contact.empty() ?
                                          growing_loads(mesh, conditions, body_force) :
                                          Loads<3>(/* time = */ 0., body_force);
    auto body = make_split_body<3>(
      std::move(mesh), conditions, materials, indenter, loads);
    set_friction(body, slopes);
    return body;
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



  /// The pressure that a cube bears between plates beside the pressure @p q on
  /// its sides: the stress has the deviator sqrt(2/3) (p - q), and the mean
  /// -(p + 2 q) / 3.
  double
  in_compression(const double degrees, const double q)
  {
    const auto [radius, slope] = strength(degrees);
    const double a = std::sqrt(2. / 3.), b = std::sqrt(2.) * slope / 3.;
    return (radius + q * (a + 2. * b)) / (a - b);
  }

  /// The pressure that its sides bear beside the pressure @p q on its ends:
  /// sqrt(2/3) (p - q) and -(2 p + q) / 3.
  double
  in_extension(const double degrees, const double q)
  {
    const auto [radius, slope] = strength(degrees);
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
    verify_exact(SoilBounds::checked_bounds(
                   make_body(cube, parameters, {everywhere}, {degrees}),
                   /* degree = */ 1),
                 in_compression(degrees, 0.));

    output() << "with a pressure on the sides" << std::endl;
    parameters.free     = {};
    parameters.traction = "right: -0.7; 0; 0 | back: 0; -0.7; 0";
    verify_exact(SoilBounds::checked_bounds(
                   make_body(cube, parameters, {everywhere}, {degrees}),
                   /* degree = */ 1),
                 in_compression(degrees, 0.7));

    output() << "Extension" << std::endl;
    parameters.contact  = {};
    parameters.free     = {"top"};
    parameters.traction = "right: -t; 0; 0 | back: 0; -t; 0";
    verify_exact(SoilBounds::checked_bounds(
                   make_body(cube, parameters, {nowhere}, {degrees}),
                   /* degree = */ 1),
                 in_extension(degrees, 0.));

    output() << "with a pressure on the top" << std::endl;
    parameters.free = {};
    parameters.traction += " | top: 0; 0; -0.7";
    verify_exact(SoilBounds::checked_bounds(
                   make_body(cube, parameters, {nowhere}, {degrees}),
                   /* degree = */ 1),
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
    verify_exact(SoilBounds::checked_bounds(
                   make_body(cube, parameters, {everywhere}, {30.}),
                   /* degree = */ 1),
                 in_compression(30., 0.));
  }



  /// The gaps know the pressure of a weight, also of one that grows.
  void
  test_weight(const Mesh &cube)
  {
    output() << "Under a weight that grows" << std::endl;
    BoundaryConditionParameters parameters;
    parameters.roller = {"left", "front", "bottom"};
    parameters.free   = {"right", "back", "top"};
    SoilBounds::checked_bounds(
      make_body(cube, parameters, {nowhere}, {10.}, "0; 0; -t"),
      /* degree = */ 1);
  }



  /// One material may have no friction.
  LimitLoad<3>
  test_footing(Mesh                      &block,
               const std::vector<double> &angles,
               const SurfaceFinish        surface,
               const std::string         &force)
  {
    output() << (surface == SurfaceFinish::rough ? "Rough" : "Smooth")
             << " footing under the weight " << force << ", angles of friction "
             << Patterns::Tools::to_string(angles) << std::endl;
    for (const auto &cell : block.active_cell_iterators())
      cell->set_material_id(cell->center()[2] > -1. ? 0 : angles.size() - 1);
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left", "front"};
    parameters.fixed   = {"bottom", "right", "back"};
    parameters.contact = {"top"};
    return SoilBounds::checked_bounds(
      make_body(block, parameters, {footing, surface}, angles, force),
      /* degree = */ 1);
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
  for (const auto &cell : cube.active_cell_iterators())
    if (cell->is_locally_owned() &&
        cell->center().distance(Point<3>(1, 1, 0)) < 0.6)
      cell->set_refine_flag();
  cube.execute_coarsening_and_refinement();
  for (const double degrees : {10., 30.})
    test_cube(cube, degrees);
  test_weight(cube);
  test_turned_cube(cube);

  Mesh block(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(
    block, {2, 2, 2}, Point<3>(0, 0, -2), Point<3>(2, 2, 0), true);
  const std::string none = "0; 0; 0", weight = "0; 0; -2";
  const auto        rough  = SurfaceFinish::rough;
  const auto        heavy  = test_footing(block, {20.}, rough, weight);
  const auto        layers = test_footing(block, {0., 20.}, rough, weight);
  const auto        alone  = test_footing(block, {20.}, rough, none);
  const auto smooth  = test_footing(block, {20.}, SurfaceFinish::smooth, none);
  const auto is_more = [](const LimitLoad<3> &more, const LimitLoad<3> &less) {
    return more.lower_bound > less.lower_bound &&
           more.upper_bound > less.upper_bound;
  };
  verify("more by weight", is_more(heavy, alone));
  verify("more by roughness", is_more(alone, smooth));
  verify("less by a layer without friction", is_more(heavy, layers));
}
