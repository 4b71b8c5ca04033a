// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Boxes and half balls: names and areas of the boundaries and of their parts,
// volumes, grading, quality after refinement, material ids, and what is said
// about mistakes.

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

#include <iostream>

#include "base/compatibility.h"
#include "mesh/geometry.h"
#include "refusal.h"

using namespace ElastoPlastic;

namespace
{
  GeometryParameters
  parameters_from(const std::string &text)
  {
    ParameterHandler   prm;
    GeometryParameters parameters;
    parameters.add_parameters(prm);
    prm.parse_input_from_string("subsection Geometry\n" + text + "\nend");
    return parameters;
  }



  template <int dim>
  using Mesh = parallel::distributed::Triangulation<dim>;



  template <int dim>
  double
  area(const Mesh<dim> &mesh, const types::boundary_id id)
  {
    const MappingQ<dim>   mapping(4);
    const FE_Nothing<dim> fe;
    const QGauss<dim - 1> quadrature(4);
    FEFaceValues<dim>     values(mapping, fe, quadrature, update_JxW_values);
    double                sum = 0;
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



  /// The smallest Jacobian at corners and inside of a cell with straight
  /// edges, relative to the cell's mean.
  template <int dim>
  double
  worst_jacobian(const Mesh<dim> &mesh)
  {
    const FE_Nothing<dim>    fe;
    const QGaussLobatto<dim> quadrature(3);
    FEValues<dim>            values(fe, quadrature, update_jacobians);
    double                   worst = 1;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          values.reinit(cell);
          for (const unsigned int q : values.quadrature_point_indices())
            worst =
              std::min(worst,
                       values.jacobian(q).determinant() / cell->measure());
        }
    return Utilities::MPI::min(worst, communicator_of(mesh));
  }



  bool
  on_first_rank()
  {
    return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }



  template <int dim>
  BoundaryNames
  make_mesh(const GeometryParameters &parameters, Triangulation<dim> &mesh)
  {
    const Geometry<dim> geometry(parameters);
    geometry.make_mesh(mesh);
    return geometry.boundary_names();
  }



  template <int dim>
  void
  print_geometry(const std::string &title, const std::string &text)
  {
    const GeometryParameters parameters = parameters_from(text);
    parameters.check(dim);
    Mesh<dim>           mesh(MPI_COMM_WORLD);
    const BoundaryNames names = make_mesh(parameters, mesh);

    const double volume = GridTools::volume(mesh, MappingQ<dim>(4));
    const double worst  = worst_jacobian(mesh);
    if (on_first_rank())
      std::cout << title << ' ' << dim << "D: " << mesh.n_global_active_cells()
                << " cells, volume " << volume
                << (worst > 0.3 ? ", good" : ", BAD") << " cells" << std::endl;
    for (const auto &[name, id] : names)
      {
        const double area_of_part = area(mesh, id);
        if (on_first_rank())
          std::cout << "  " << name << ": " << area_of_part << std::endl;
      }
  }



  /// Lengths of the cells along a line of a box with a single row of cells.
  template <int dim>
  void
  print_steps(const std::string &text, const unsigned int direction)
  {
    Triangulation<dim> mesh;
    make_mesh(parameters_from(text), mesh);
    std::cout << "steps:";
    for (const auto &cell : mesh.active_cell_iterators())
      std::cout << ' ' << cell->extent_in_direction(direction);
    std::cout << std::endl;
  }



  /// Volume of the material 1 on a mesh that is refined, coarsened and refined.
  template <int dim>
  void
  print_material_volume(const std::string &text)
  {
    Mesh<dim> mesh(MPI_COMM_WORLD);
    make_mesh(parameters_from(text), mesh);
    const auto volume = [&mesh]() {
      double sum = 0;
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == 1)
          sum += cell->measure();
      return Utilities::MPI::sum(sum, communicator_of(mesh));
    };
    const auto adapt = [&mesh](const bool refine) {
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            if (!refine)
              cell->set_coarsen_flag();
            else if (cell->center()[0] < 0.5)
              cell->set_refine_flag();
          }
      mesh.execute_coarsening_and_refinement();
    };

    std::vector<double> volumes = {volume()};
    adapt(true);
    volumes.push_back(volume());
    adapt(false);
    adapt(false);
    mesh.refine_global(3);
    volumes.push_back(volume());
    if (on_first_rank())
      {
        std::cout << "volume of material 1:";
        for (const double v : volumes)
          std::cout << ' ' << v;
        std::cout << std::endl;
      }
  }



  template <int dim>
  void
  print_error(const std::string &text)
  {
    const std::string message = refusal([&]() {
      const GeometryParameters parameters = parameters_from(text);
      parameters.check(dim);
      Mesh<dim> mesh(MPI_COMM_WORLD);
      make_mesh(parameters, mesh);
    });
    if (on_first_rank())
      std::cout << message << '\n' << std::endl;
  }



  void
  print_geometries()
  {
    print_geometry<2>("unit box", "");
    print_geometry<3>("unit box", "set Initial refinements = 1");
    print_geometry<2>("box",
                      "set Lower corner = -1, -2\n set Upper corner = 3, 0\n"
                      "set Repetitions = 4, 2");
    print_geometry<3>("graded box",
                      "set Lower corner = -1, -1, -2\n"
                      "set Upper corner = 3, 2, 0\n"
                      "set Repetitions = 4\n set Grading = 5\n"
                      "set Grading centre = 0, -1");
    print_geometry<3>("box with a quarter of a circle",
                      "set Lower corner = 0, 0, -2\n"
                      "set Upper corner = 4, 3, 0\n"
                      "set Repetitions = 2\n set Circle radius = 1\n"
                      "set Initial refinements = 2");
    print_geometry<3>("box with a circle",
                      "set Lower corner = -1, -1, -2\n"
                      "set Upper corner = 3, 2, 0\n"
                      "set Repetitions = 4, 3, 2\n set Grading = 2\n"
                      "set Circle centre = 1, 0\n set Circle radius = 0.5\n"
                      "set Grading centre = 1, 0\n"
                      "set Initial refinements = 1");
    for (const std::string part : {"full", "half"})
      print_geometry<2>(part + " ball",
                        "set Type = half ball\n set Radius = 2\n set Part = " +
                          part + "\n set Initial refinements = 3");
    for (const std::string part : {"full", "half", "quarter"})
      print_geometry<3>(part + " ball",
                        "set Type = half ball\n set Radius = 2\n set Part = " +
                          part + "\n set Initial refinements = 2");
    print_geometry<2>("box with parts of boundaries",
                      "set Repetitions = 4, 2\n set Local refinements = 3\n"
                      "set Boundary parts = strip: top; abs(x - 0.5) < 0.25 |"
                      " corner: left; y > 0.5 | rest: top; x < 0.5");
    print_geometry<3>("box with a part of a boundary",
                      "set Repetitions = 2\n set Initial refinements = 1\n"
                      "set Boundary parts = patch: top; x > 0.5 && y < 0.5");
  }



  void
  print_box_errors()
  {
    print_error<2>("set Lower corner = 0, 0, 0");
    print_error<3>("set Upper corner = 1, 1");
    print_error<2>("set Lower corner = 0, 1");
    print_error<3>("set Repetitions = 2, 2");
    print_error<2>("set Repetitions = 2, 0");
    print_error<2>("set Grading = 0.5");
    print_error<3>("set Grading centre = 0");
    print_error<2>("set Grading centre = 2");
    print_error<2>("set Grading centre = 0.5");
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  print_geometries();

  if (on_first_rank())
    {
      print_steps<2>("set Repetitions = 1, 3\n set Grading = 4", 1);
      print_steps<2>(
        "set Repetitions = 4, 1\n set Grading = 2\n"
        "set Grading centre = 0.5",
        0);
      print_steps<2>(
        "set Repetitions = 3, 1\n set Grading = 4\n"
        "set Grading centre = 0",
        0);
    }

  print_material_volume<2>(
    "set Initial refinements = 2\n"
    "set Material id = if(y > 0.7, 1, 0)");
  print_material_volume<3>(
    "set Initial refinements = 1\n"
    "set Material id = if(x < 0.3, 1.2, 0)");
  print_material_volume<2>(
    "set Local refinements = 4\n"
    "set Material id = if(x + y < 0.1, 1, 0)");
  if (on_first_rank())
    std::cout << std::endl;

  print_box_errors();
  print_error<2>("set Type = half ball\n set Radius = 0");
  print_error<2>("set Type = half ball\n set Part = quarter");
  print_error<2>("set Initial refinements = 1\n set Material id = x - 1.5");
  print_error<2>("set Type = file\n set File = missing.msh");
}
