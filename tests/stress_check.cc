// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The independent check of stresses in equilibrium: whatever is wrong with them
// shows.

#include <deal.II/base/mpi.h>

#include "bounds/stress/stress_check.h"
#include "bounds/stress/stress_problem.h"
#include "section_body.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  void
  test_check()
  {
    Triangulation<2> mesh;
    make_rectangle(mesh, MeshKind::regular, 2, 0., 1., 1.);
    const auto        conditions = on_rollers({"left", "bottom"}, {"right"});
    const PlaneBody   body       = make_body(mesh, conditions, everywhere);
    const StressField field      = maximize_load(body, 2);
    const auto        error      = [&](const auto &damage) {
      StressField damaged = field;
      damage(damaged);
      return check_stress(body, damaged);
    };
    constexpr double change = 1e-3;
    verify("circumferential stress", error([](StressField &f) {
                                       f.circumferential[0][1] += change;
                                     }).divergence > 0.1 * change);
    verify("component 33", error([](StressField &f) {
                             f.out_of_plane[0][2] += change;
                           }).circumferential > change);
    verify("traction between the ends of a side", error([](StressField &f) {
                                                    f.in_plane[0][3 * 3] +=
                                                      change;
                                                  }).largest() > 0.1 * change);
    verify("yield condition", error([](StressField &f) {
                                for (auto &of_triangle : f.in_plane)
                                  of_triangle *= 1. + change;
                              }).yield_excess > 0.1 * change);
    verify("axis", error([](StressField &f) {
                     for (auto &of_triangle : f.in_plane)
                       of_triangle.add(change);
                   }).on_axis > change);
    verify("force", error([](StressField &f) {
                      f.force *= 1. + change;
                    }).force_difference > 0.5 * change);
  }



  // A sheet between a roller and a load on its right side.
  PlaneBody
  make_sheet(const SideCondition::Value &load)
  {
    Triangulation<2> mesh;
    make_rectangle(mesh, MeshKind::regular, 1, 0., 1., 1.);
    const auto conditions = on_rollers({"left", "bottom"}, {"right"});
    PlaneBody  body       = make_body(mesh,
                               conditions,
                               everywhere,
                               SurfaceFinish::smooth,
                               Kinematics::plane_stress);
    for (unsigned int s = 0; s < body.mesh.sides.size(); ++s)
      if (body.mesh.sides[s].boundary_id == names.at("right"))
        body.conditions[s].components[0].value = load;
    return body;
  }



  void
  test_sheet()
  {
    const PlaneBody body  = make_sheet([](const Point<2> &) { return 0.1; });
    StressField     field = maximize_load(body, 1);
    verify("sheet", check_stress(body, field).largest(), 1e-8);
    field.out_of_plane[0][0] = 1e-3;
    verify("stress across the sheet",
           check_stress(body, field).largest() > 0.9e-3);

    // zero at the ends, in the middle and at the points of the quadrature
    const PlaneBody waves = make_sheet([](const Point<2> &x) {
      const double t = -x[1], s = 2. * t - 1.;
      return 0.1 + t * (1. - t) * s * (63. * s * s * s * s - 70. * s * s + 15.);
    });
    verify("waves of a traction",
           check_stress(waves, maximize_load(waves, 2)).boundary_force > 0.1);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_check();
  test_sheet();
}
