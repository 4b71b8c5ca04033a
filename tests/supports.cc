// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Supports hold what they promise, whatever the body does otherwise: fixed and
// prescribed displacements with hanging nodes, rollers on planes and on curved
// boundaries, and where these meet.

#include "supported_body.h"
#include "verdict.h"

using namespace ElastoPlastic;
using namespace SupportedBodies;

namespace
{
  /// A row of cells on a slope, held under every third of them, so that the
  /// supports meet at many nodes, some of them beside other ranks.
  BoundaryNames
  row_on_slope(Mesh<2> &mesh)
  {
    GridGenerator::subdivided_hyper_rectangle(mesh,
                                              {8, 1},
                                              Point<2>(),
                                              Point<2>(8., 1.));
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          face->set_boundary_id(face->center()[1] > 0 ? 2 :
                                static_cast<int>(face->center()[0]) % 3 == 2 ?
                                                        1 :
                                                        0);
    GridTools::transform(
      [](const Point<2> &x) { return Point<2>(x[0], x[1] + 2. * x[0]); }, mesh);
    return {{"slope", 0}, {"held", 1}, {"rest", 2}};
  }



  template <int dim>
  Tensor<1, dim>
  axis(const unsigned int d)
  {
    Tensor<1, dim> result;
    result[d] = 1.;
    return result;
  }



  void
  check_block(const unsigned int degree)
  {
    output() << "block, p = " << degree << std::endl;
    const SupportedBody<3> body(block<3>,
                                degree,
                                "set Fixed = right\n"
                                "set Roller = front, bottom\n"
                                "set Prescribed displacement = top: "
                                "0.02*t*(1-x); free; -0.04*t*(1-x)\n"
                                "set Free = left, back");
    output() << "  " << body.n_fixed() << " fixed unknowns" << std::endl;
    verify("  fixed, with hanging nodes",
           body.largest("right",
                        [](const auto &, const auto &u) { return u.norm(); }),
           1e-15);
    verify("  prescribed displacement, with hanging nodes",
           body.largest("top",
                        [](const auto &x, const auto &u) {
                          return std::abs(u[0] - 0.01 * (1. - x[0])) +
                                 std::abs(u[2] + 0.02 * (1. - x[0]));
                        }),
           1e-15);
    verify("  a free component is left alone",
           body.largest_along("top", axis<3>(1)) > 0.1);
    verify("  rollers hold the normal displacement",
           body.largest_along("front", axis<3>(1)) +
             body.largest_along("bottom", axis<3>(2)),
           1e-15);
    verify("  rollers do not hold others",
           body.largest_along("front", axis<3>(0)) > 0.1 &&
             body.largest_along("bottom", axis<3>(1)) > 0.1);
  }



  /// The displacement along the radius vanishes on the curved boundary.
  template <int dim>
  double
  radial_displacement(const SupportedBody<dim> &body)
  {
    return body.largest("curved", [](const auto &x, const auto &u) {
      return u * Tensor<1, dim>(x);
    });
  }



  void
  check_half_balls(const unsigned int degree)
  {
    output() << "half balls on curved rollers, p = " << degree << std::endl;
    verify("  half disc",
           radial_displacement(
             SupportedBody<2>(part_of_ball<2>(HalfBallPart::full),
                              degree,
                              "set Roller = curved\nset Free = top")),
           1e-14);
    verify("  half ball",
           radial_displacement(
             SupportedBody<3>(part_of_ball<3>(HalfBallPart::full),
                              degree,
                              "set Roller = curved\nset Free = top")),
           1e-14);

    const SupportedBody<3> quarter(part_of_ball<3>(HalfBallPart::quarter),
                                   degree,
                                   "set Roller = curved, left, front\n"
                                   "set Free = top");
    verify("  quarter, where the rollers meet",
           radial_displacement(quarter) +
             quarter.largest_along("left", axis<3>(0)) +
             quarter.largest_along("front", axis<3>(1)),
           1e-14);
  }



  /// At the tip, the roller on the left and the one on the slope leave nothing
  /// free.
  void
  check_wedge()
  {
    const SupportedBody<2> body(wedge,
                                1,
                                "set Roller = left, slope\n"
                                "set Free = right, top");
    const Tensor<1, 2>     normal({2., -1.});
    output() << "wedge on a slope" << std::endl;
    verify("  rollers hold the normal displacement",
           body.largest_along("left", axis<2>(0)) +
             body.largest_along("slope", normal),
           1e-14);
    verify("  but not the tangential one",
           body.largest_along("slope", Tensor<1, 2>({1., 2.})) > 0.1);
  }



  void
  check_partition()
  {
    const SupportedBody<2> body(row_on_slope,
                                1,
                                "set Roller = slope\nset Fixed = held\n"
                                "set Free = rest");
    output() << "row of cells on a slope" << std::endl;
    verify("  all ranks state the same conditions", body.ranks_agree());
    const double norm = body.norm();
    output() << "  norm of the displacement: " << norm << std::endl;
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      check_block(degree);
      check_half_balls(degree);
    }
  check_wedge();
  check_partition();
}
