// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Sectors of a round block, for several angles: volume and areas of the
// boundaries, cells that are good and stay so when they are refined, planes
// that stay planes, grading; and what is said about mistakes.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/numerics/vector_tools.h>

#include <set>

#include "base/compatibility.h"
#include "mesh/geometry.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  using Mesh = parallel::distributed::Triangulation<3>;

  constexpr double radius = 2, height = 3;

  GeometryParameters
  parameters_from(const std::string &text)
  {
    ParameterHandler   prm;
    GeometryParameters parameters;
    parameters.add_parameters(prm);
    prm.parse_input_from_string("subsection Geometry\nset Type = sector\n" +
                                text + "\nend");
    return parameters;
  }



  GeometryParameters
  sector(const double angle, const std::string &refinements)
  {
    return parameters_from(
      "set Radius = 2\nset Height = 3\n"
      "set Core radius = 0.1\nset Sector angle = " +
      std::to_string(angle) + "\n" + refinements);
  }



  BoundaryNames
  make_mesh(const GeometryParameters &parameters, Mesh &mesh)
  {
    parameters.check(3);
    const Geometry<3> geometry(parameters);
    geometry.make_mesh(mesh);
    return geometry.boundary_names();
  }



  double
  area(const Mesh &mesh, const types::boundary_id id)
  {
    const MappingQ<3>   mapping(4);
    const FE_Nothing<3> fe;
    const QGauss<2>     quadrature(4);
    FEFaceValues<3>     values(mapping, fe, quadrature, update_JxW_values);
    double              sum = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == id)
            {
              values.reinit(cell, f);
              for (const double dS : values.get_JxW_values())
                sum += dS;
            }
    return Utilities::MPI::sum(sum, communicator_of(mesh));
  }



  /// The smallest Jacobian of a cell with straight edges, over the lengths of
  /// the columns: 1 stands for right angles, 0 for a cell without volume there.
  double
  worst_angles(const Mesh &mesh)
  {
    const FE_Nothing<3>    fe;
    const QGaussLobatto<3> quadrature(3);
    FEValues<3>            values(fe, quadrature, update_jacobians);
    double                 worst = 1;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          values.reinit(cell);
          for (const auto &jacobian : values.get_jacobians())
            {
              const Tensor<2, 3> columns = transpose(Tensor<2, 3>(jacobian));
              worst                      = std::min(worst,
                               determinant(columns) /
                                 (columns[0].norm() * columns[1].norm() *
                                  columns[2].norm()));
            }
        }
    return Utilities::MPI::min(worst, communicator_of(mesh));
  }



  /// How far the vertices of a boundary are from the plane through the origin.
  double
  distance_from_plane(const Mesh              &mesh,
                      const types::boundary_id id,
                      const Tensor<1, 3>      &normal)
  {
    double distance = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      if (!cell->is_artificial())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == id)
            for (const unsigned int v : face->vertex_indices())
              distance = std::max(distance, std::abs(face->vertex(v) * normal));
    return Utilities::MPI::max(distance, communicator_of(mesh));
  }



  /// How far hanging nodes are from the middle of the edge or face that they
  /// lie on. Where they are apart, neighbours overlap or gape.
  double
  largest_gap(const Mesh &mesh)
  {
    const FE_Q<3> fe(1);
    DoFHandler<3> dof_handler(mesh);
    dof_handler.distribute_dofs(fe);
    const IndexSet relevant =
      DoFTools::extract_locally_relevant_dofs(dof_handler);
    AffineConstraints<double> hanging = empty_constraints(dof_handler);
    DoFTools::make_hanging_node_constraints(dof_handler, hanging);
    hanging.close();

    double gap = 0;
    for (unsigned int d = 0; d < 3; ++d)
      {
        LinearAlgebra::distributed::Vector<double> x(
          dof_handler.locally_owned_dofs(), relevant, MPI_COMM_WORLD);
        VectorTools::interpolate(dof_handler,
                                 ScalarFunctionFromFunctionObject<3>(
                                   [d](const Point<3> &point) {
                                     return point[d];
                                   }),
                                 x);
        auto middles = x;
        x.update_ghost_values();
        middles.update_ghost_values();
        hanging.distribute(middles);
        middles -= x;
        gap = std::max(gap, middles.linfty_norm());
      }
    return gap;
  }



  /// The exact areas of the boundaries, and the names that there are.
  std::map<std::string, double>
  exact_areas(const double angle)
  {
    const double                  arc   = angle * numbers::PI / 180 * radius;
    std::map<std::string, double> areas = {{"top", arc * radius / 2},
                                           {"bottom", arc * radius / 2},
                                           {"side", arc * height},
                                           {"front", radius * height},
                                           {"back", radius * height}};
    if (angle == 180)
      {
        areas["front"] += areas["back"];
        areas.erase("back");
      }
    return areas;
  }



  /// Local refinement where the boundary is round. There, larger cells beside
  /// smaller ones have straight edges along its arcs, as at all curved
  /// boundaries.
  const char *const at_side =
    "set Local refinements = 3\nset Local centre = 2, 0, -1";



  void
  check_sector(const double angle, const std::string &refinements)
  {
    Mesh                mesh(MPI_COMM_WORLD);
    const BoundaryNames names = make_mesh(sector(angle, refinements), mesh);
    const double        phi   = angle * numbers::PI / 180;
    const double        exact = 0.5 * phi * radius * radius * height;

    verify("  volume",
           std::abs(GridTools::volume(mesh, MappingQ<3>(4)) / exact - 1),
           refinements == at_side ? 1e-3 : 1e-5);
    bool                                areas_ok = true;
    const std::map<std::string, double> areas    = exact_areas(angle);
    for (const auto &[name, id] : names)
      areas_ok = areas_ok && areas.count(name) > 0 &&
                 std::abs(area(mesh, id) / areas.at(name) - 1) < 1e-5;
    verify("  names and areas of the boundaries",
           areas_ok && names.size() == areas.size());
    verify("  no bad cells", worst_angles(mesh) > 0.3);
    verify("  the front is exactly at y = 0",
           distance_from_plane(mesh, names.at("front"), Point<3>(0, 1, 0)),
           0.);
    if (refinements != at_side)
      verify("  neighbours fit together", largest_gap(mesh), 1e-14);
    if (angle < 180)
      verify("  the back is a plane",
             distance_from_plane(mesh,
                                 names.at("back"),
                                 Point<3>(std::sin(phi), -std::cos(phi), 0)),
             1e-15);
  }



  /// With straight edges, a quarter of the error is left when cells are halved.
  void
  check_convergence(const double angle)
  {
    const double exact =
      0.5 * angle * numbers::PI / 180 * radius * radius * height;
    std::vector<double> errors;
    for (const std::string n : {"1", "2"})
      {
        Mesh mesh(MPI_COMM_WORLD);
        make_mesh(sector(angle, "set Initial refinements = " + n), mesh);
        errors.push_back(exact - GridTools::volume(mesh, MappingQ<3>(1)));
      }
    verify("  the volume converges with the square of the cells' size",
           std::abs(errors[0] / errors[1] - 4) < 0.1);
  }



  /// Along the edge of the top that lies in the front, from the axis.
  void
  print_grading(const std::string &text)
  {
    Mesh mesh(MPI_COMM_SELF);
    make_mesh(parameters_from(text), mesh);
    std::set<double> radii, depths;
    for (const Point<3> &x : mesh.get_vertices())
      {
        if (x[1] == 0 && x[2] == 0)
          radii.insert(x[0]);
        if (x[0] == 0 && x[1] == 0)
          depths.insert(std::abs(x[2]));
      }
    output() << mesh.n_active_cells() << " cells, radii:";
    for (const double r : radii)
      output() << ' ' << r;
    output() << ", depths:";
    for (const double z : depths)
      output() << ' ' << z;
    output() << std::endl;
  }



  void
  print_message(const std::string &text, const unsigned int dim = 3)
  {
    print_error(text, [&]() { parameters_from(text).check(dim); });
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const double angle : {20., 45., 60., 90., 100., 101., 150., 180.})
    {
      output() << "sector of " << angle << " degrees" << std::endl;
      for (const std::string refinements :
           {"",
            "set Initial refinements = 2",
            "set Initial refinements = 1\n"
            "set Local refinements = 3\nset Local radius = 0.3",
            at_side})
        check_sector(angle, refinements);
      check_convergence(angle);
    }

  print_grading("");
  print_grading("set Radius = 6\nset Height = 3\nset Core radius = 0.05");

  print_message("", 2);
  for (const std::string entry : {"Radius = 0",
                                  "Sector angle = 0",
                                  "Sector angle = 180.1",
                                  "Core radius = 0.6",
                                  "Core radius = 0",
                                  "Height = 0.2"})
    print_message("set " + entry);
}
