// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Rollers on the planes of symmetry of a sector of a round block, which meet at
// the axis, with hanging nodes on both: they hold what symmetry does.

#include "refine_where.h"
#include "supported_body.h"
#include "verdict.h"

using namespace ElastoPlastic;
using namespace SupportedBodies;

namespace
{
  MeshMaker<3>
  sector(const double angle)
  {
    return [=](Mesh<3> &mesh) {
      SectorParameters parameters;
      parameters.angle          = angle;
      const BoundaryNames names = make_sector<3>(parameters, mesh);
      mesh.refine_global(1);
      for (const double size : {0.2, 0.1})
        refine_where(mesh, [&](const auto &cell) {
          return cell->center().distance(Point<3>(0, 0, -0.1)) < size;
        });
      return names;
    };
  }



  /// Of the nodes on the axis.
  double
  horizontal_displacement(const SupportedBody<3> &body)
  {
    return body.largest("front", [](const auto &x, const auto &u) {
      return std::hypot(x[0], x[1]) < 1e-12 ? std::hypot(u[0], u[1]) : 0.;
    });
  }



  void
  check_sector(const double angle, const unsigned int degree)
  {
    output() << "sector of " << angle << " degrees, p = " << degree
             << std::endl;
    const double       phi = angle * numbers::PI / 180;
    const Tensor<1, 3> normal({std::sin(phi), -std::cos(phi), 0.});
    const Tensor<1, 3> along({std::cos(phi), std::sin(phi), 0.});
    const std::string  planes = angle < 180 ? "front, back" : "front";
    const std::string  back   = angle < 180 ? "back" : "front";

    const SupportedBody<3> body(sector(angle),
                                degree,
                                "set Roller = " + planes +
                                  "\nset Free = top, bottom, side");
    verify("  rollers hold the normal displacement",
           body.largest_along("front", Tensor<1, 3>({0., 1., 0.})) +
             body.largest_along(back, normal),
           1e-14);
    verify("  but no other one",
           body.largest_along("front", Tensor<1, 3>({1., 0., 0.})) > 0.1 &&
             body.largest_along(back, along) > 0.1 &&
             body.largest_along(back, Tensor<1, 3>({0., 0., 1.})) > 0.1);
    if (angle < 180)
      verify("  at the axis, all horizontal ones",
             horizontal_displacement(body),
             1e-14);
    verify("  all ranks state the same conditions", body.ranks_agree());
    const std::string motion = body.free_motion();
    output() << "  what is left: " << motion << std::endl;
  }



  /// Where all three meet.
  void
  check_side(const double angle)
  {
    output() << "sector of " << angle << " degrees in a cylinder" << std::endl;
    const Tensor<1, 3>     normal({std::sin(angle * numbers::PI / 180),
                                   -std::cos(angle * numbers::PI / 180),
                                   0.});
    const SupportedBody<3> in_cylinder(sector(angle),
                                       1,
                                       "set Roller = side, front, back\n"
                                       "set Free = top, bottom");
    verify("  rollers hold the normal displacement",
           in_cylinder.largest_along("front", Tensor<1, 3>({0., 1., 0.})) +
             in_cylinder.largest_along("back", normal) +
             in_cylinder.largest("side",
                                 [](const auto &x, const auto &u) {
                                   return u[0] * x[0] + u[1] * x[1];
                                 }),
           1e-13);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    for (const double angle : {45., 60., 90., 120., 180.})
      check_sector(angle, degree);
  for (const double angle : {45., 60., 90., 120.})
    check_side(angle);
}
