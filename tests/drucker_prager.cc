// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Bounds of limit loads of bodies of revolution whose material obeys Drucker
// and Prager's yield condition: a cylinder between smooth plates and a tube
// under internal pressure, whose limit loads are known, circular footings, also
// with a weight, and what they tend to as the friction vanishes. Velocities are
// strictly inside of their cones, and the gaps of the triangles add up to the
// difference of the bounds.

#include <deal.II/base/mpi.h>
#include <deal.II/base/patterns.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "soil_bounds.h"

using namespace ElastoPlastic;
using SoilBounds::strength;

namespace
{
  using Mesh = parallel::distributed::Triangulation<2>;

  const std::map<std::string, types::boundary_id> names = {{"left", 0},
                                                           {"right", 1},
                                                           {"bottom", 2},
                                                           {"top", 3}};

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



  /// Materials with these angles of friction, by material id.
  SplitBody<2>
  make_body(const Mesh                        &triangulation,
            const BoundaryConditionParameters &parameters,
            const IndenterOnBody<2>           &indenter,
            const std::vector<double>         &angles,
            const std::string                 &force = "0; 0")
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
    const BoundaryConditions<2> conditions(parameters, names);
    const BodyForce<2>          body_force(force);
    SplitMesh<2>                mesh  = make_split_mesh(triangulation);
    const Loads<2>              loads = parameters.contact.empty() ?
                                          growing_loads(mesh, conditions, body_force) :
                                          Loads<2>(/* time = */ 0., body_force);
    auto body = make_split_body<2>(std::move(mesh),
                                   conditions,
                                   materials,
                                   indenter,
                                   loads,
                                   Kinematics::axisymmetric);
    set_friction(body, slopes);
    return body;
  }



  /// Uniform stress and rate: |dev s| = sqrt(2/3) p, tr s = -p.
  void
  test_cylinder(const double degrees)
  {
    output() << "Cylinder, angle of friction " << degrees << std::endl;
    Mesh triangulation(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_rectangle(
      triangulation, {2, 2}, Point<2>(0, 0), Point<2>(1, 1), true);
    BoundaryConditionParameters parameters;
    parameters.roller          = {"left", "bottom"};
    parameters.free            = {"right"};
    parameters.contact         = {"top"};
    const auto [radius, slope] = strength(degrees);
    const double limit =
      numbers::PI * radius / (std::sqrt(2. / 3.) - std::sqrt(2.) * slope / 3.);
    const auto bounds =
      SoilBounds::checked_bounds(make_body(triangulation,
                                           parameters,
                                           plate(1., SurfaceFinish::smooth),
                                           {degrees}),
                                 /* degree = */ 2);
    verify("lower bound",
           bounds.lower_bound <= limit * (1. + 1e-9) &&
             bounds.lower_bound >= limit * (1. - 2e-6));
    verify("upper bound",
           bounds.upper_bound >= limit * (1. - 1e-9) &&
             bounds.upper_bound <= limit * (1. + 2e-6));
  }



  /// A tube between smooth plates flows in plane strain, where the cone bears
  /// as much as Mohr and Coulomb's: (p + T) / T = (b / a)^(2 sin(phi) / (1 +
  /// sin(phi))), T = c cot(phi).
  void
  test_tube(const double degrees)
  {
    output() << "Tube, angle of friction " << degrees << std::endl;
    Mesh triangulation(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_rectangle(
      triangulation, {12, 2}, Point<2>(1, 0), Point<2>(2, 0.2), true);
    BoundaryConditionParameters parameters;
    parameters.roller   = {"bottom", "top"};
    parameters.free     = {"right"};
    parameters.traction = "left: t; 0";
    const double phi = degrees * numbers::PI / 180., sine = std::sin(phi);
    const double limit =
      (std::pow(2., 2. * sine / (1. + sine)) - 1.) / std::tan(phi);
    const auto bounds =
      SoilBounds::checked_bounds(make_body(triangulation,
                                           parameters,
                                           plate(-1., SurfaceFinish::smooth),
                                           {degrees}),
                                 /* degree = */ 2);
    verify("lower bound",
           bounds.lower_bound <= limit && bounds.lower_bound >= 0.999 * limit);
    verify("upper bound",
           bounds.upper_bound >= limit && bounds.upper_bound <= 1.001 * limit);
  }



  /// A block with smaller cells at the edge of the footing, whose radius is 1.
  void
  make_ground(Mesh &triangulation)
  {
    GridGenerator::subdivided_hyper_rectangle(
      triangulation, {6, 6}, Point<2>(0, -6), Point<2>(6, 0), true);
    for (unsigned int k = 0; k < 3; ++k)
      {
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned() &&
              cell->center().distance(Point<2>(1., 0.)) <
                2.5 * cell->diameter())
            cell->set_refine_flag();
        triangulation.execute_coarsening_and_refinement();
      }
  }



  /// Where there are two materials, the first is above.
  LimitLoad<2>
  test_footing(const Mesh                &triangulation,
               const std::vector<double> &angles,
               const SurfaceFinish        surface,
               const std::string         &force = "0; 0")
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      cell->set_material_id(cell->center()[1] > -1. ? 0 : angles.size() - 1);
    output() << "Footing, angle of friction "
             << Patterns::Tools::to_string(angles)
             << (surface == SurfaceFinish::rough ? ", rough" : "")
             << (force != "0; 0" ? ", weight" : "") << std::endl;
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left"};
    parameters.fixed   = {"bottom", "right"};
    parameters.contact = {"top"};
    return SoilBounds::checked_bounds(
      make_body(triangulation, parameters, plate(1., surface), angles, force),
      /* degree = */ 2);
  }



  /// A ring around a wide hole, which is 1 high and deforms as a section in
  /// plane strain, where the cone bears as much as Mohr and Coulomb's: the
  /// weight that it bears by unit of the cohesion.
  LimitLoad<2>
  test_vertical_cut(const double radius)
  {
    output() << "Vertical cut at the radius " << radius << std::endl;
    Mesh triangulation(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_rectangle(triangulation,
                                              {12, 8},
                                              Point<2>(radius, 0),
                                              Point<2>(radius + 1.5, 1),
                                              true);
    BoundaryConditionParameters parameters;
    parameters.fixed  = {"bottom"};
    parameters.roller = {"right"};
    parameters.free   = {"left", "top"};
    return SoilBounds::checked_bounds(make_body(triangulation,
                                                parameters,
                                                plate(-1.,
                                                      SurfaceFinish::smooth),
                                                {30.},
                                                "0; -t"),
                                      /* degree = */ 2);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const double degrees : {10., 30.})
    test_cylinder(degrees);
  for (const double degrees : {10., 30.})
    test_tube(degrees);
  Mesh triangulation(MPI_COMM_WORLD);
  make_ground(triangulation);
  const auto smooth  = SurfaceFinish::smooth;
  const auto without = test_footing(triangulation, {0.}, smooth);
  const auto hardly  = test_footing(triangulation, {0.1}, smooth);
  verify("almost the stresses without friction",
         hardly.lower_bound > without.lower_bound &&
           hardly.lower_bound < 1.005 * without.lower_bound);
  // (Velocities that lose those without a change of volume as the angle tends
  // to zero would be far too stiff.)
  verify("mechanisms not far from those without friction",
         hardly.upper_bound < 1.25 * without.upper_bound);
  const auto layer = test_footing(triangulation, {0., 20.}, smooth);
  verify("a layer without friction: stresses",
         1. - layer.lower_bound / without.lower_bound,
         1e-6);
  verify("its mechanisms", layer.upper_bound / without.upper_bound - 1., 0.25);
  const auto weak   = test_footing(triangulation, {10.}, smooth);
  const auto strong = test_footing(triangulation, {30.}, smooth);
  for (const auto &bounds : {weak, strong})
    verify("bounds", bounds.upper_bound / bounds.lower_bound - 1., 0.08);
  const auto rough = test_footing(triangulation, {30.}, SurfaceFinish::rough);
  const auto heavy = test_footing(triangulation, {30.}, smooth, "0; -1");
  verify("more by friction", strong.lower_bound > weak.upper_bound);
  verify("more by roughness", rough.lower_bound > strong.upper_bound);
  verify("more by weight", heavy.lower_bound > strong.upper_bound);
  // (In plane strain, a log spiral through the toe gives 6.69, and no mechanism
  // less than 2 percent below it is known.)
  const auto cut = test_vertical_cut(/* radius = */ 1e3);
  verify("around that in plane strain",
         cut.lower_bound < 6.69 && cut.upper_bound > 0.98 * 6.69);
}
