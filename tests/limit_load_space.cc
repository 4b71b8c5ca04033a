// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Bounds of limit loads in space: exact where they can be, on either side of
// the exact limit load else, and admissible to rounding errors whatever the
// mesh.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "bounds/limit_load.h"
#include "bounds/stress/stress_check.h"
#include "box_names.h"
#include "contact/gap_function.h"
#include "indenter/indenter_parameters.h"
#include "mesh/ready_meshes.h"
#include "refine_where.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  const double k = 1. / std::sqrt(3.); // the yield stress is 1

  using Gap  = std::function<double(const Point<3> &)>;
  using Mesh = parallel::distributed::Triangulation<3>;

  const Gap everywhere = [](const Point<3> &) {
    return 0.;
  };



  Material<double>
  material()
  {
    Material<double> material;
    material.bulk_modulus      = 800.;
    material.shear_modulus     = 400.;
    material.yield_radius      = std::sqrt(2. / 3.);
    material.isotropic_modulus = 0.;
    return material;
  }



  BoundaryConditionParameters
  on_rollers(const std::vector<std::string> &rollers)
  {
    BoundaryConditionParameters parameters;
    parameters.roller = rollers;
    for (const std::string name : {"left", "right", "front", "back", "bottom"})
      if (std::find(rollers.begin(), rollers.end(), name) == rollers.end())
        parameters.free.push_back(name);
    parameters.contact = {"top"};
    return parameters;
  }



  /// Three faces of each tetrahedron inside, two tetrahedra at each of them.
  void
  verify_mesh(const SplitMesh<3> &mesh, const double exact_volume)
  {
    double sum = 0, flat = 0;
    for (const auto &tetrahedron : mesh.simplices)
      sum += volume(mesh.corners(tetrahedron));
    unsigned int n_outside = 0;
    for (const auto &face : mesh.faces)
      if (!face.is_inside())
        {
          ++n_outside;
          flat += area(mesh.corners(face));
        }
    output() << mesh.simplices.size() << " tetrahedra" << std::endl;
    verify("volume", std::abs(sum / exact_volume - 1.), 1e-12);
    verify("surface of a cube",
           std::abs(flat / (6. * std::pow(exact_volume, 2. / 3.)) - 1.),
           1e-12);
    verify("conforming",
           4 * mesh.simplices.size() == 2 * mesh.faces.size() - n_outside);
  }



  /// A limit load, or strict bounds of it that a finer mesh has found.
  struct Limit
  {
    double lower, upper;
  };



  /// The bounds, relative to those of the @p limit, are between @p least and 1,
  /// and between 1 and @p most.
  void
  verify_bounds(const std::string  &title,
                const SplitBody<3> &body,
                const LimitLoad<3> &bounds,
                const Limit        &limit,
                const double        least,
                const double        most)
  {
    const double lower = bounds.stress.force / limit.upper,
                 upper = bounds.velocity.bound / limit.lower;
    output() << title << std::endl;
    verify("lower bound", lower >= least && lower <= 1. + 1e-10);
    verify("upper bound", upper <= most && upper >= 1. - 1e-10);
    verify("admissible stress", require_admissible(body, bounds.stress), 1e-9);
    verify("admissible velocity", bounds.velocity.error, 1e-9);
    verify("gaps",
           *std::min_element(bounds.gaps.begin(), bounds.gaps.end()) > -1e-9);
    verify("sum of the gaps",
           std::accumulate(bounds.gaps.begin(), bounds.gaps.end(), 0.) <=
             bounds.velocity.bound - bounds.stress.force + 1e-6);
  }



  // The stress is uniform, and so is the strain rate.
  void
  test_plates(const std::string                 &title,
              const SplitMesh<3>                &mesh,
              const BoundaryConditionParameters &parameters,
              const double                       exact)
  {
    constexpr double            error = 1e-8;
    const BoundaryConditions<3> conditions(parameters, names_of_box);
    const SplitBody<3>          body =
      make_split_body<3>(mesh, conditions, {material()}, {everywhere}, 0.);
    verify_bounds(title,
                  body,
                  bound_limit_load(body, 1, 0.1 * error),
                  {exact, exact},
                  1. - error,
                  1. + error);
  }



  void
  test_plates(const SplitMesh<3> &mesh)
  {
    const auto uniaxial = on_rollers({"left", "front", "bottom"});
    test_plates("Smooth plates", mesh, uniaxial, 1.);
    test_plates("Smooth plates, plane strain",
                mesh,
                on_rollers({"left", "front", "back", "bottom"}),
                2. * k);
    auto pressed     = uniaxial;
    pressed.free     = {};
    pressed.traction = "right: -0.7; 0; 0 | back: 0; -0.7; 0";
    test_plates("Smooth plates, and a pressure on the sides",
                mesh,
                pressed,
                1.7);
  }



  // The limits are those on a mesh that is refined where needed; without the
  // small cells, bounds are 0.89 and 1.131 of them.
  void
  test_square_punch(const SplitMesh<3> &mesh,
                    const SurfaceFinish surface,
                    const Limit        &limit)
  {
    auto parameters  = on_rollers({"left", "front"});
    parameters.free  = {"right", "back"};
    parameters.fixed = {"bottom"};
    const BoundaryConditions<3> conditions(parameters, names_of_box);
    const Gap                   punch = [](const Point<3> &x) {
      return std::max(x[0], x[1]) <= 1. ?
                                 0. :
                                 std::numeric_limits<double>::infinity();
    };
    const SplitBody<3> body =
      make_split_body<3>(mesh, conditions, {material()}, {punch, surface}, 0.);
    verify_bounds(surface == SurfaceFinish::rough ? "Rough square punch" :
                                                    "Smooth square punch",
                  body,
                  bound_limit_load(body, 1),
                  limit,
                  0.9,
                  1.13);
  }



  // The limits are those of a body of revolution, of which a block this large
  // bears as much; the mesh has two edges of cells on a quarter of the circle,
  // whose polygons alone are 0.900 and 1.055 of the disc.
  void
  test_disc(const std::string        &title,
            const SplitMesh<3>       &mesh,
            const IndenterParameters &indenter,
            const Limit              &limit,
            const double              most)
  {
    auto parameters  = on_rollers({"left", "front"});
    parameters.free  = {"right", "back"};
    parameters.fixed = {"bottom"};
    const GapFunction<3> gap(make_indenter<3>(indenter), 0., 1);
    const SplitBody<3>   body =
      make_split_body<3>(mesh,
                         BoundaryConditions<3>(parameters, names_of_box),
                         {material()},
                         {[&gap](const Point<3> &x) { return gap.value(x); },
                          indenter.surface,
                          ContactGeometry::vertical,
                          gap.footprint()},
                         0.);
    verify_bounds(title,
                  body,
                  bound_limit_load(body, 1, 1e-3),
                  {numbers::PI_4 * limit.lower, numbers::PI_4 * limit.upper},
                  0.8,
                  most);
  }



  void
  test_discs(const SplitMesh<3> &mesh)
  {
    IndenterParameters punch;
    punch.type   = "circular punch";
    punch.radius = 1.;
    test_disc("Smooth circular punch", mesh, punch, {3.0127, 3.0156}, 1.2);
    IndenterParameters sphere;
    sphere.type   = "sphere";
    sphere.radius = 3.;
    sphere.reach  = 1.;
    test_disc(
      "Sphere that reaches as far", mesh, sphere, {3.0127, 3.0156}, 1.2);
    punch.surface = SurfaceFinish::rough;
    test_disc("Rough circular punch", mesh, punch, {3.1819, 3.1899}, 1.24);
  }



  void
  test_messages(const SplitMesh<3> &mesh)
  {
    print_error("Tractions that are not linear", [&]() {
      auto parameters     = on_rollers({"left", "front", "bottom", "back"});
      parameters.free     = {};
      parameters.traction = "right: x*y^2; 0; 0";
      make_split_body<3>(mesh,
                         BoundaryConditions<3>(parameters, names_of_box),
                         {material()},
                         {everywhere},
                         0.);
    });

    const BoundaryConditions<3> closed(
      on_rollers({"left", "front", "back", "right", "bottom"}), names_of_box);
    const SplitBody<3> body =
      make_split_body<3>(mesh, closed, {material()}, {everywhere}, 0.);
    SplitMesh<3> distorted = mesh;
    distorted.vertices[mesh.simplices[0].vertices[3]] += Point<3>(2, 2, 2);
    print_error("A centre outside of its cell", [&]() {
      make_split_body<3>(distorted, closed, {material()}, {everywhere}, 0.);
    });
    print_error("Enclosed", [&]() { minimize_plastic_work(body); });
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
  refine_where(cube, [](const auto &cell) {
    return cell->center().distance({1, 1, 0}) < 0.6;
  });

  Mesh block(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(
    block, {2, 2, 2}, Point<3>(0, 0, -2), Point<3>(2, 2, 0), true);
  refine_where(block,
               [](const auto &cell) { return cell->center().norm() < 1.; });

  Mesh          block_with_circle(MPI_COMM_WORLD);
  BoxParameters box;
  box.lower_corner   = {0., 0., -5.};
  box.upper_corner   = {5., 5., 0.};
  box.repetitions    = {2, 2, 4};
  box.grading        = 2.;
  box.grading_centre = {0., 0.};
  box.circle_radius  = 1.;
  make_box(box, block_with_circle);

  const SplitMesh<3> mesh_of_cube     = make_split_mesh(cube),
                     mesh_of_block    = make_split_mesh(block),
                     mesh_with_circle = make_split_mesh(block_with_circle);
  verify_mesh(mesh_of_cube, 1.);
  verify_mesh(mesh_of_block, 8.);
  test_plates(mesh_of_cube);
  // (with 9,126 and 8,326 tetrahedra)
  test_square_punch(mesh_of_block, SurfaceFinish::smooth, {2.3354, 2.4395});
  test_square_punch(mesh_of_block, SurfaceFinish::rough, {2.3487, 2.4653});
  test_discs(mesh_with_circle);
  test_messages(mesh_of_cube);
}
