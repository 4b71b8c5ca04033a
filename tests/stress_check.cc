// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The independent check of stresses in equilibrium: whatever is wrong with them
// shows.

#include <deal.II/base/mpi.h>

#include "bounds/stress/stress_check.h"
#include "bounds/stress/stress_field.h"
#include "section_body.h"
#include "verdict.h"

using namespace ElastoPlastic;
using namespace SectionBody;

namespace
{
  void
  test_check()
  {
    Triangulation<2> mesh;
    make_rectangle(mesh, MeshKind::regular, 2, 0., 1., 1.);
    const auto           conditions = on_rollers({"left", "bottom"}, {"right"});
    const SplitBody<2>   body       = make_body(mesh, conditions, everywhere);
    const StressField<2> field      = maximize_load(body, 2);
    const auto           error      = [&](const auto &damage) {
      StressField<2> damaged = field;
      damage(damaged);
      return check_stress(body, damaged);
    };
    constexpr double change = 1e-3;
    verify("circumferential stress", error([](StressField<2> &f) {
                                       f.circumferential[0][1] += change;
                                     }).divergence > 0.1 * change);
    verify("component 33", error([](StressField<2> &f) {
                             f.values[0][4 * 2 + 3] += change;
                           }).circumferential > change);
    verify("traction between the ends of a side", error([](StressField<2> &f) {
                                                    f.values[0][4 * 3] +=
                                                      change;
                                                  }).largest() > 0.1 * change);
    verify("yield condition", error([](StressField<2> &f) {
                                for (auto &of_triangle : f.values)
                                  of_triangle *= 1. + change;
                              }).yield_excess > 0.1 * change);
    verify("axis", error([](StressField<2> &f) {
                     for (auto &of_triangle : f.values)
                       of_triangle.add(change);
                   }).on_axis > change);
    verify("force", error([](StressField<2> &f) {
                      f.force *= 1. + change;
                    }).force_difference > 0.5 * change);
  }



  // A sheet between a roller and a load on its right side.
  SplitBody<2>
  make_sheet(const std::function<double(const Point<2> &)> &load)
  {
    Triangulation<2> mesh;
    make_rectangle(mesh, MeshKind::regular, 1, 0., 1., 1.);
    const auto   conditions = on_rollers({"left", "bottom"}, {"right"});
    SplitBody<2> body       = make_body(mesh,
                                  conditions,
                                  everywhere,
                                  SurfaceFinish::smooth,
                                  Kinematics::plane_stress);
    for (unsigned int s = 0; s < body.mesh.faces.size(); ++s)
      if (body.mesh.faces[s].boundary_id == names.at("right"))
        body.conditions[s].components[0].value = {
          [load](const FacePoint<2> &point) {
            return load(point.x);
          }};
    return body;
  }



  void
  test_sheet()
  {
    const SplitBody<2> body  = make_sheet([](const Point<2> &) { return 0.1; });
    StressField<2>     field = maximize_load(body, 1);
    verify("sheet", check_stress(body, field).largest(), 1e-8);
    field.values[0][3] = 1e-3;
    verify("stress across the sheet",
           check_stress(body, field).largest() > 0.9e-3);

    // zero at the ends, in the middle and at the points of the quadrature
    const SplitBody<2> waves = make_sheet([](const Point<2> &x) {
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
