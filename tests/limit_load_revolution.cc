// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Bounds of the limit loads of bodies of revolution against exact values: on
// either side of them, whatever the mesh, and admissible to rounding errors.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "bounds/limit_load.h"
#include "bounds/stress/stress_check.h"
#include "bounds/stress/stress_field.h"
#include "section_body.h"
#include "verdict.h"

using namespace ElastoPlastic;
using namespace SectionBody;

namespace
{
  const double k = 1. / std::sqrt(3.); // the yield stress is 1

  const Gap up_to_radius_1 = [](const Point<2> &x) {
    return x[0] <= 1. ? 0. : std::numeric_limits<double>::infinity();
  };



  /// A limit load, or strict bounds of it that have been found before.
  struct Limit
  {
    double lower, upper;
  };

  Limit
  exactly(const double force)
  {
    return {force, force};
  }



  /// The bounds, relative to those of the @p limit, are between @p least and 1,
  /// and between 1 and @p most.
  void
  verify_bounds(const std::string  &title,
                const SplitBody<2> &body,
                const Limit        &limit,
                const double        least,
                const double        most)
  {
    for (const unsigned int degree : {1, 2})
      {
        const LimitLoad<2> bounds = bound_limit_load(body, degree);
        const double       lower  = bounds.stress.force / limit.upper,
                     upper        = bounds.velocity.bound / limit.lower;
        output() << title << ", degree " << degree << std::endl;
        verify("below the exact limit", lower <= 1. + 1e-12);
        verify("near to it", lower >= least);
        verify("admissible stress",
               check_stress(body, bounds.stress).largest(),
               1e-9);
        verify("above the exact limit", upper >= 1. - 1e-12);
        verify("near to it", upper <= most);
        verify("admissible velocity", bounds.velocity.error, 1e-9);
        verify("gaps",
               *std::min_element(bounds.gaps.begin(), bounds.gaps.end()) >
                 -1e-8);
        verify("sum of the gaps",
               std::accumulate(bounds.gaps.begin(), bounds.gaps.end(), 0.) <=
                 bounds.velocity.bound - bounds.stress.force + 1e-6);
      }
  }



  // sigma_zz = -1 - q, with the pressure q on the jacket.
  void
  test_plates(const MeshKind kind)
  {
    const double     jacket = 0.7;
    Triangulation<2> mesh;
    make_rectangle(mesh, kind, 2, 0., 1., 1.5);
    const auto   conditions = on_rollers({"left", "bottom"}, {"right"});
    SplitBody<2> body       = make_body(mesh, conditions, everywhere);
    press(body, 1, jacket);
    verify_bounds("Cylinder between smooth plates" + kinds.at(kind),
                  body,
                  exactly(numbers::PI * (1. + jacket)),
                  1. - 1e-6,
                  1. + 1e-6);
  }



  // sigma_rz = k / r: the inner wall is drawn down, the outer one is held; no
  // other load.
  void
  test_axial_shear(const MeshKind kind)
  {
    Triangulation<2> mesh;
    make_rectangle(mesh, kind, 2, 1., 2., 1.);
    BoundaryConditionParameters parameters;
    parameters.contact                 = {"left"};
    parameters.fixed                   = {"right"};
    parameters.prescribed_displacement = "bottom: 0; free | top: 0; free";
    const BoundaryConditions<2> conditions(parameters, names);
    verify_bounds("Tube under axial shear" + kinds.at(kind),
                  make_body(mesh, conditions, everywhere),
                  exactly(2. * numbers::PI * k),
                  1. - 1e-6,
                  1.2);
  }



  /// That a body bears the part @p safe of its limit pressure, but not more
  /// than all of it.
  void
  verify_pressure(
    const std::string                                    &title,
    const std::function<SplitBody<2>(const double part)> &body_under,
    const double                                          safe)
  {
    const SplitBody<2>   body  = body_under(safe);
    const StressField<2> field = maximize_load(body, 2);
    output() << title << std::endl;
    verify("admissible", check_stress(body, field).largest(), 1e-9);
    print_error("Beyond its limit",
                [&]() { maximize_load(body_under(1.001), 2); });
  }



  // Pressure on both walls, so that the smooth plates need not pull.
  void
  test_tube(const MeshKind kind)
  {
    Triangulation<2> mesh;
    make_rectangle(mesh, kind, 6, 1., 2., 0.5);
    const auto conditions = on_rollers({"bottom"}, {"left", "right"});
    verify_pressure(
      "Tube" + kinds.at(kind),
      [&](const double part) {
        SplitBody<2> body = make_body(mesh, conditions, everywhere);
        press(body, 0, 2. + part * 2. * k * std::log(2.));
        press(body, 1, 2.);
        return body;
      },
      0.99);
  }



  // As in the tube; the plate is the plane z = 0.
  void
  test_hollow_sphere()
  {
    Triangulation<2> mesh;
    make_shell(mesh, 12);
    const auto conditions = on_rollers({"bottom"}, {"left", "right"});
    verify_pressure(
      "Hollow sphere",
      [&](const double part) {
        SplitBody<2> body = make_body(mesh, conditions, everywhere);
        press(body, 0, 2. + part * 2. * std::log(2.));
        press(body, 1, 2.);
        return body;
      },
      0.97);
  }



  // Own strict bounds, times the yield stress: 3.0140 to 3.0147 for a smooth
  // punch, 3.1766 to 3.189 for a rough one. What flows is within a radius of 2
  // and a depth of 1.5, so that held sides change nothing.
  void
  test_circular_punch(const MeshKind kind,
                      const double   least,
                      const double   most)
  {
    Triangulation<2> mesh;
    make_rectangle(mesh, kind, 5, 0., 2.5, 2.5);
    BoundaryConditionParameters parameters;
    parameters.roller  = {"left"};
    parameters.fixed   = {"bottom", "right"};
    parameters.contact = {"top"};
    const BoundaryConditions<2> conditions(parameters, names);
    verify_bounds("Smooth circular punch" + kinds.at(kind),
                  make_body(mesh, conditions, up_to_radius_1),
                  {3.0140 * numbers::PI, 3.0147 * numbers::PI},
                  least,
                  most);
    if (kind == MeshKind::refined)
      verify_bounds(
        "Rough circular punch" + kinds.at(kind),
        make_body(mesh, conditions, up_to_radius_1, SurfaceFinish::rough),
        {3.1766 * numbers::PI, 3.189 * numbers::PI},
        least,
        most);
  }



  // A block that is turned, between plates that press along its own axis.
  void
  test_inclined_plates()
  {
    constexpr double angle = numbers::PI / 6.;
    Triangulation<2> mesh;
    make_rectangle(mesh, MeshKind::refined, 2, 0., 1., 1.);
    GridTools::rotate(angle, mesh);
    const auto conditions = on_rollers({"bottom"}, {"left", "right"});
    for (const auto geometry :
         {ContactGeometry::normal, ContactGeometry::automatic})
      verify_bounds(
        "Block between inclined plates, " +
          Patterns::Tools::to_string(geometry),
        make_split_body<2>(make_split_mesh(mesh),
                           conditions,
                           {material()},
                           {everywhere, SurfaceFinish::smooth, geometry},
                           /* time = */ 0.),
        exactly(2. * k * std::cos(angle)),
        1. - 1e-6,
        1. + 1e-6);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const MeshKind kind :
       {MeshKind::regular, MeshKind::refined, MeshKind::distorted})
    {
      test_plates(kind);
      test_axial_shear(kind);
      test_tube(kind);
    }
  test_hollow_sphere();
  test_circular_punch(MeshKind::regular, 0.92, 1.04);
  test_circular_punch(MeshKind::refined, 0.97, 1.02);
  test_circular_punch(MeshKind::distorted, 0.91, 1.04);
  test_inclined_plates();
}
