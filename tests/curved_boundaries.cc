// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Refinement follows the circles, spheres and cylinders that the boundary of a
// mesh file consists of, and no other boundary; its length and area converge.

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <sstream>

#include "gmsh_text.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// @p mesh as a file, each of its boundaries as a physical group.
  template <int dim>
  std::string
  file_of(const Triangulation<dim> &mesh)
  {
    std::ostringstream nodes, elements;
    nodes.precision(12);
    for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
      nodes << v + 1 << ' ' << mesh.get_vertices()[v] << (dim == 2 ? " 0" : "")
            << '\n';
    unsigned int n_elements = 0;
    const auto   add        = [&](const unsigned int               type,
                         const auto                      &item,
                         const unsigned int               group,
                         const std::vector<unsigned int> &order) {
      elements << ++n_elements << ' ' << type << " 2 " << group << ' ' << group;
      for (const unsigned int v : order)
        elements << ' ' << item.vertex_index(v) + 1;
      elements << '\n';
    };
    for (const auto &cell : mesh.active_cell_iterators())
      {
        if constexpr (dim == 2)
          add(3, *cell, 1, {0, 1, 3, 2});
        else
          add(5, *cell, 1, {0, 1, 3, 2, 4, 5, 7, 6});
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            {
              if constexpr (dim == 2)
                add(1, *face, face->boundary_id() + 1, {0, 1});
              else
                add(3, *face, face->boundary_id() + 1, {0, 1, 3, 2});
            }
      }
    std::ostringstream file;
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
         << mesh.n_vertices() << '\n'
         << nodes.str() << "$EndNodes\n$Elements\n"
         << n_elements << '\n'
         << elements.str() << "$EndElements\n";
    return file.str();
  }



  /// The length of an edge, or half the product of the diagonals of a face.
  template <int dim, typename Face>
  double
  measure_of(const Face &face)
  {
    if constexpr (dim == 2)
      return face.measure();
    else
      return 0.5 * cross_product_3d(face.vertex(3) - face.vertex(0),
                                    face.vertex(2) - face.vertex(1))
                     .norm();
  }



  /// Refines a mesh from a file twice. @return the relative errors of the
  /// length or area of the first boundary, which the file calls 1.
  template <int dim>
  std::vector<double>
  errors_of_measure(const Triangulation<dim> &original,
                    const double              exact,
                    const Curves              curves = Curves::followed)
  {
    std::vector<double> errors;
    Triangulation<dim>  mesh(Triangulation<dim>::none, true);
    GmshFileParameters  parameters;
    parameters.curves = curves;
    make_mesh_from_text(file_of(original), mesh, parameters);
    for (unsigned int level = 0; level < 3; ++level)
      {
        double measure = 0;
        for (const auto &cell : mesh.active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() == 1)
              measure += measure_of<dim>(*face);
        errors.push_back(std::abs(measure / exact - 1));
        if (level < 2)
          mesh.refine_global(1);
      }
    return errors;
  }



  /// A polygon's error is of second order in the length of its sides.
  template <int dim>
  void
  verify_followed(const std::string        &name,
                  const Triangulation<dim> &original,
                  const double              exact)
  {
    const std::vector<double> errors = errors_of_measure(original, exact);
    verify(name + " is not exact at first", errors[0] > 2e-3);
    for (unsigned int level = 1; level < errors.size(); ++level)
      verify("  its error becomes a quarter (+-7 %)",
             std::abs(4 * errors[level] / errors[level - 1] - 1) < 0.07);
  }



  template <int dim>
  void
  verify_straight(const std::string        &name,
                  const Triangulation<dim> &original,
                  const double              exact,
                  const Curves              curves = Curves::followed)
  {
    const auto errors = errors_of_measure(original, exact, curves);
    verify(name + " stays as it is", std::abs(errors[2] - errors[0]) < 1e-12);
  }



  /// Three cells between an arc of 60 degrees, which is the boundary 0, and a
  /// straight line 0.005 above the highest chord of it.
  Triangulation<2>
  thin_cells_over_arc()
  {
    std::vector<Point<2>>    vertices;
    std::vector<CellData<2>> cells;
    const double             top = std::sin(100. * numbers::PI / 180.) + 0.005;
    for (unsigned int i = 0; i < 4; ++i)
      {
        const double angle = (120. - 20. * i) * numbers::PI / 180.;
        vertices.emplace_back(std::cos(angle), std::sin(angle));
        vertices.emplace_back(std::cos(angle), top);
        if (i > 0)
          {
            cells.emplace_back();
            cells.back().vertices = {2 * i - 2, 2 * i, 2 * i - 1, 2 * i + 1};
          }
      }
    Triangulation<2> mesh;
    mesh.create_triangulation(vertices, cells, SubCellData());
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(face->center().norm() < 0.99 &&
                                  face->center()[1] < top - 1e-6 &&
                                  std::abs(face->center()[0]) < 0.49 ?
                                0 :
                                1);
    return mesh;
  }



  void
  test_curves()
  {
    Triangulation<2> ring;
    GridGenerator::hyper_shell(ring, Point<2>(3., 4.), 0.5, 1., 8, true);
    verify_followed("a circle", ring, numbers::PI);
    verify_straight("a circle that is not to be followed",
                    ring,
                    numbers::PI,
                    Curves::straight);
    GridTools::transform(
      [](const Point<2> &x) { return Point<2>(x[0], 2. * x[1]); }, ring);
    verify_straight("an ellipse", ring, 4.8442);

    Triangulation<2> square;
    GridGenerator::hyper_cube(square, 0., 1., true);
    verify_straight("a square", square, 1.);
    verify_straight("an arc under cells that are thinner than it is high",
                    thin_cells_over_arc(),
                    numbers::PI / 3.);
  }



  void
  test_surfaces()
  {
    Triangulation<3> shell, fine_shell;
    GridGenerator::hyper_shell(shell, Point<3>(1., 2., 3.), 0.5, 1., 6, true);
    shell.refine_global(2);
    GridGenerator::flatten_triangulation(shell, fine_shell);
    verify_followed("a sphere", fine_shell, numbers::PI);

    Triangulation<3> pipe;
    GridGenerator::cylinder_shell(pipe, 2., 0.5, 1., 12, 2);
    for (const auto &cell : pipe.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            const Point<3> x = face->center();
            face->set_all_boundary_ids(x[2] < 1e-6                   ? 1 :
                                       x[2] > 2. - 1e-6              ? 2 :
                                       std::hypot(x[0], x[1]) < 0.75 ? 0 :
                                                                       3);
          }
    GridTools::rotate(Tensor<1, 3>({1, 0, 0}), 0.5, pipe);
    verify_followed("a skew cylinder", pipe, 2. * numbers::PI);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_curves();
  test_surfaces();
}
