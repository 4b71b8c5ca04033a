// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Rigid body motions that supports do not prevent are found and named: of
// bodies in one piece and in two.

#include "supported_body.h"
#include "verdict.h"

using namespace ElastoPlastic;
using namespace SupportedBodies;

namespace
{
  /// Two squares of four cells, or cubes of eight, apart from each other.
  template <int dim>
  BoundaryNames
  two_blocks(Mesh<dim> &mesh)
  {
    Triangulation<dim> first, second;
    GridGenerator::hyper_cube(first, 0., 1.);
    GridGenerator::hyper_cube(second, 3., 4.);
    GridGenerator::merge_triangulations(first, second, mesh);
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          face->set_boundary_id(cell->center()[1] > 1. ? 1 : 0);
    mesh.refine_global(1);
    return {{"first", 0}, {"second", 1}};
  }



  template <int dim>
  void
  print_free_motion(const MeshMaker<dim> &make_mesh,
                    const std::string    &conditions)
  {
    const SupportedBody<dim> body(make_mesh, 1, conditions);
    output() << '[' << conditions << "]\n  free motion in " << dim
             << "D: " << body.free_motion() << std::endl;
  }



  void
  check_free_motions()
  {
    print_free_motion<2>(block<2>,
                         "set Roller = bottom\nset Free = left, right, top");
    print_free_motion<2>(block<2>,
                         "set Roller = left\nset Free = bottom, right, top");
    print_free_motion<2>(block<2>,
                         "set Roller = left, top\nset Free = bottom, right");
    print_free_motion<2>(block<2>,
                         "set Fixed = top\nset Free = bottom, right, left");
    print_free_motion<2>(wedge,
                         "set Roller = left, slope\nset Free=right, top");
    print_free_motion<2>(part_of_ball<2>(HalfBallPart::full),
                         "set Roller = curved\nset Free = top");
    print_free_motion<2>(part_of_ball<2>(HalfBallPart::half),
                         "set Roller = curved, left\nset Free = top");
    print_free_motion<3>(block<3>,
                         "set Roller = bottom, left\n"
                         "set Free = top, front, back, right");
    print_free_motion<3>(block<3>,
                         "set Roller = bottom, left, back\n"
                         "set Free = top, front, right");
    print_free_motion<3>(part_of_ball<3>(HalfBallPart::full),
                         "set Roller = curved, top");
    print_free_motion<3>(part_of_ball<3>(HalfBallPart::quarter),
                         "set Roller = curved, left\nset Free = front, top");
    print_free_motion<3>(part_of_ball<3>(HalfBallPart::quarter),
                         "set Roller = curved, left, front\nset Free = top");
    print_free_motion<2>(two_blocks<2>, "set Fixed = first\nset Free = second");
    print_free_motion<3>(two_blocks<3>, "set Fixed = second\nset Free = first");
    print_free_motion<2>(two_blocks<2>, "set Fixed = first, second");
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_free_motions();
}
