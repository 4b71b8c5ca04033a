// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Supports hold what they promise, whatever the body does otherwise: fixed and
// prescribed displacements with hanging nodes, rollers on planes and on curved
// boundaries, and where these meet. What they do not hold is named.

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/vector_tools.h>

#include "mechanics/rigid_body_modes.h"
#include "mechanics/supports.h"
#include "mesh/half_ball.h"
#include "sample_mesh.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Vector = LinearAlgebra::distributed::Vector<double>;

  template <int dim>
  using Mesh = parallel::distributed::Triangulation<dim>;

  /// Makes a mesh. @return the names of its boundaries.
  template <int dim>
  using MeshMaker = std::function<BoundaryNames(Mesh<dim> &)>;



  template <int dim>
  BoundaryNames
  block(Mesh<dim> &mesh)
  {
    GridGenerator::subdivided_hyper_cube(mesh, 2, 0., 1., true);
    refine_corner(mesh);
    if (dim == 2)
      return {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}};
    return {{"left", 0},
            {"right", 1},
            {"front", 2},
            {"back", 3},
            {"bottom", 4},
            {"top", 5}};
  }



  /// A quadrilateral that stands on a slope of 63 degrees, normal (2, -1).
  BoundaryNames
  wedge(Mesh<2> &mesh)
  {
    const std::vector<Point<2>> vertices = {{0, 0}, {1, 2}, {0, 3}, {1, 3}};
    std::vector<CellData<2>>    cells(1);
    cells[0].vertices = {0, 1, 2, 3};
    mesh.create_triangulation(vertices, cells, SubCellData());
    const auto cell = mesh.begin_active();
    for (const unsigned int f : cell->face_indices())
      cell->face(f)->set_boundary_id(f);
    mesh.refine_global(1);
    return {{"left", 0}, {"right", 1}, {"slope", 2}, {"top", 3}};
  }



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
  MeshMaker<dim>
  part_of_ball(const HalfBallPart part)
  {
    return [=](Mesh<dim> &mesh) {
      HalfBallParameters parameters;
      parameters.part           = part;
      const BoundaryNames names = make_half_ball<dim>(parameters, mesh);
      mesh.refine_global(1);
      return names;
    };
  }



  template <int dim>
  class SupportedBody
  {
  public:
    SupportedBody(const MeshMaker<dim> &make_mesh,
                  const unsigned int    degree,
                  const std::string    &conditions)
      : mesh(MPI_COMM_WORLD)
      , names(make_mesh(mesh))
      , fe(FE_Q<dim>(degree), dim)
      , dof_handler(mesh)
    {
      ParameterHandler            prm;
      BoundaryConditionParameters parameters;
      parameters.add_parameters(prm);
      prm.parse_input_from_string("subsection Boundary conditions\n" +
                                  conditions + "\nend");
      dof_handler.distribute_dofs(fe);
      supports.reinit(dof_handler,
                      BoundaryConditions<dim>(parameters, names),
                      /* time = */ 0.5);

      u.reinit(dof_handler.locally_owned_dofs(),
               supports.constraints().get_local_lines(),
               MPI_COMM_WORLD);
      VectorTools::interpolate(dof_handler, SampleField<dim>(0, 1.), u);
      supports.move_fixed(u);
      supports.constraints().distribute(u);
      u.update_ghost_values();
    }

    /// The largest |violation(x, u(x))| at the nodes of a boundary.
    double
    largest(
      const std::string &boundary,
      const std::function<double(const Point<dim> &, const Tensor<1, dim> &)>
        &violation) const
    {
      const Quadrature<dim - 1>   nodes(fe.get_unit_face_support_points());
      FEFaceValues<dim>           values(fe,
                               nodes,
                               update_values | update_quadrature_points);
      std::vector<Tensor<1, dim>> displacements(nodes.size());
      double                      result = 0;
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() &&
                cell->face(f)->boundary_id() == names.at(boundary))
              {
                values.reinit(cell, f);
                values[FEValuesExtractors::Vector(0)].get_function_values(
                  u, displacements);
                for (const unsigned int q : values.quadrature_point_indices())
                  result =
                    std::max(result,
                             std::abs(violation(values.quadrature_point(q),
                                                displacements[q])));
              }
      return Utilities::MPI::max(result, MPI_COMM_WORLD);
    }

    /// The largest displacement along @p normal at the nodes of a boundary.
    double
    largest_along(const std::string    &boundary,
                  const Tensor<1, dim> &normal) const
    {
      return largest(boundary,
                     [&](const auto &, const auto &u) { return u * normal; });
    }

    /// The number of fixed unknowns on all ranks.
    double
    n_fixed() const
    {
      Vector marks(u.locally_owned_elements(), MPI_COMM_WORLD);
      supports.set_fixed_entries(marks, 1.);
      return marks.l1_norm();
    }

    /// Whether all ranks state the same conditions for the nodes that they
    /// know.
    bool
    ranks_agree() const
    {
      return supports.constraints().is_consistent_in_parallel(
        Utilities::MPI::all_gather(MPI_COMM_WORLD,
                                   dof_handler.locally_owned_dofs()),
        supports.constraints().get_local_lines(),
        MPI_COMM_WORLD);
    }

    double
    norm() const
    {
      return u.l2_norm();
    }

    std::string
    free_motion() const
    {
      Vector layout(u.locally_owned_elements(),
                    supports.constraints().get_local_lines(),
                    MPI_COMM_WORLD);
      Vector held = layout;
      supports.set_fixed_entries(held, 1.);
      return find_free_motion<dim>(rigid_body_modes(dof_handler, layout),
                                   held,
                                   supports.constraints());
    }

  private:
    Mesh<dim>           mesh;
    const BoundaryNames names;
    const FESystem<dim> fe;
    DoFHandler<dim>     dof_handler;
    Supports<dim>       supports;
    Vector              u;
  };



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
  check_free_motions();
}
