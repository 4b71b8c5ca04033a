// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Mesh files of Gmsh: both formats, names of boundaries, and what is said about
// meshes that do not fit and about damaged files.

#include <deal.II/base/mpi.h>

#include <iostream>
#include <set>
#include <sstream>

#include "gmsh_text.h"

using namespace ElastoPlastic;

namespace
{
  const std::string two_squares = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 1 "foot"
1 2 "top side"
2 7 "steel"
$EndPhysicalNames
$Nodes
7
1 0 0 5
2 1 0 5
3 2 0 5
4 0 1 5
15 1 1 5
6 2 1 5
9 4 4 5
$EndNodes
$Elements
8
1 15 2 0 1 1
2 1 2 1 1 1 2
3 1 2 1 1 2 3
4 1 2 2 2 6 15
5 1 2 2 2 15 4
6 1 2 5 3 3 6
7 3 2 7 1 1 2 15 4
8 3 2 8 1 2 15 6 3
$EndElements
)";

  const std::string one_square = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 "foot"
2 7 "steel"
$EndPhysicalNames
$Entities
1 4 1 0
1 0 0 0 0
1 0 0 0 1 0 0 1 1 2 1 2
2 1 0 0 1 1 0 0 2 2 3
3 0 1 0 1 1 0 1 -5 2 3 4
4 0 0 0 0 1 0 0 2 4 1
1 0 0 0 1 1 0 1 7 4 1 2 3 4
$EndEntities
$Nodes
2 4 1 4
1 1 1 2
1
2
0 0 0 0
1 0 0 1
2 1 0 2
3
4
1 1 0
0 1 0
$EndNodes
$Elements
3 3 1 3
1 1 1 1
1 1 2
1 3 1 1
2 3 4
2 1 3 1
3 1 2 3 4
$EndElements
$Comments
anything
$EndComments
)";

  const std::string cube = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
2 4 "lid"
$EndPhysicalNames
$Nodes
8
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
$EndNodes
$Elements
2
1 3 2 4 1 5 6 7 8
2 5 2 3 1 1 2 3 4 5 6 7 8
$EndElements
)";

  /// Two squares that have the corner (1, 1) in common.
  const std::string hinge = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
7
1 0 0 0
2 1 0 0
3 0 1 0
4 1 1 0
5 2 1 0
6 1 2 0
7 2 2 0
$EndNodes
$Elements
4
1 1 2 1 1 1 2
2 1 2 2 2 4 5
3 3 2 3 1 1 2 4 3
4 3 2 3 1 4 5 7 6
$EndElements
)";



  /// One square on the left, two half as high on the right.
  const std::string hanging_node = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
8
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 0.5 0
6 2 0.5 0
7 1 1 0
8 2 1 0
$EndNodes
$Elements
4
1 1 2 1 1 1 2
2 3 2 3 1 1 2 7 4
3 3 2 3 1 2 3 6 5
4 3 2 3 1 5 6 8 7
$EndElements
)";



  /// Two squares side by side, whose common nodes have been written twice.
  const std::string slit = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
8
1 0 0 0
2 1 0 0
3 0 1 0
4 1 1 0
5 1 0 0
6 2 0 0
7 1 1 0
8 2 1 0
$EndNodes
$Elements
3
1 1 2 1 1 1 2
2 3 2 3 1 1 2 4 3
3 3 2 3 1 5 6 8 7
$EndElements
)";



  template <int dim>
  void
  print_mesh(const std::string &text)
  {
    Triangulation<dim>  mesh;
    const BoundaryNames names = make_mesh_from_text(text, mesh);
    std::cout << mesh.n_used_vertices() << " vertices" << std::endl;
    for (const auto &cell : mesh.active_cell_iterators())
      std::cout << "cell: centre " << cell->center() << ", measure "
                << cell->measure() << ", material " << cell->material_id()
                << std::endl;
    // (the order of a cell's faces is deal.II's)
    for (const auto &[name, id] : names)
      {
        std::multiset<std::string> lines;
        for (const auto &cell : mesh.active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() == id)
              {
                std::ostringstream line;
                line << "  " << name << ": centre " << face->center();
                lines.insert(line.str());
              }
        for (const std::string &line : lines)
          std::cout << line << std::endl;
      }
  }



  void
  print_meshes_that_do_not_fit()
  {
    print_error<2>(cube);
    print_error<3>(two_squares);
    print_error<2>(change(two_squares, "2 0 5", "2 0 4"));
    print_error<2>(
      change(two_squares, "7 3 2 7 1 1 2 15 4", "7 2 2 7 1 1 2 4"));
    print_error<2>(change(two_squares, "7 3 2 7 1 1 2 15 4", "7 26 1 1"));
    print_error<3>(change(cube, "2 5 2 3", "2 4 2 3"));
    print_error<2>(change(one_square, "2 1 3 1\n3 1", "2 1 15 1\n3 "));
    print_error<3>(change(cube, "1 3 2 4 1", "1 3 2 0 0"));
    print_error<2>(change(two_squares, "top side", "top|side"));
    print_error<2>(change(two_squares, "top side", "top #1"));
    print_error<2>(change(two_squares, "top side", "foot"));
    print_error<2>(change(one_square, "1 7 4", "2 7 8 4"));
    print_error<2>(hanging_node);
    print_error<2>(
      change(two_squares, "8 3 2 8 1 2 15 6 3", "8 3 2 8 1 1 2 15 4"));
    print_error<2>(change(two_squares, "3 1 2 1 1 2 3", "3 1 2 2 1 1 2"));
  }



  void
  print_damaged_files()
  {
    print_error<2>("");
    print_error<2>("solid cube");
    print_error<2>(change(two_squares, "2.2 0", "2.2 1"));
    print_error<2>(change(two_squares, "2.2 0", "3.0 0"));
    print_error<2>(change(two_squares, "\"foot\"", "\"foot"));
    print_error<2>(change(two_squares, "2 1 0 5", "2 1 nan 5"));
    print_error<2>(change(two_squares, "2 1 0 5", "1 1 0 5"));
    print_error<2>(change(two_squares, "\n7\n", "\n6\n"));
    print_error<2>(change(two_squares, "\n7\n", "\n8\n"));
    print_error<2>(change(two_squares, "\n8\n", "\n-8\n"));
    print_error<2>(change(two_squares, "1 1 2 15 4", "1 1 2 16 4"));
    print_error<2>(change(two_squares, "1 1 2 15 4", "1 1 2 15 2"));
    print_error<2>(change(two_squares, "1 1 2 15 4", "1 1 2 4 15"));
    print_error<2>(change(two_squares, "15 1 1 5", "15 0.3 0.3 5"));
    print_error<2>(change(two_squares, "2 15 6 3", "1 2 15 4"));
    print_error<2>(change(change(two_squares, "\n8\n", "\n9\n"),
                          "$EndElements",
                          "9 3 2 8 1 2 3 9 15\n$EndElements"));
    print_error<2>(two_squares.substr(0, 300));
    print_error<2>(change(one_square, "2 1 0 2\n3\n", "2 1 0 9999999\n3\n"));
    print_error<2>(change(one_square, "2 4 1 4", "2 5 1 4"));
    print_error<2>(change(one_square, "3 3 1 3", "3 4 1 3"));
    print_error<2>(change(one_square, "$EndComments", ""));
    print_error<2>(change(cube, "", "\x89PNG\r\n"));
    print_error<2>(
      change(two_squares, "2 1 2 1 1 1 2", "2 1 2 4294967295 1 1 2"));
    print_error<2>(
      change(two_squares, "2 1 2 1 1 1 2", "2 1 2 4294967299 1 1 2"));
    print_error<2>(
      change(two_squares, "1 1 \"foot\"", "1 -4294967295 \"foot\""));
    print_error<2>(change(one_square, "1 7 4", "1 4294967299 4"));
    print_error<2>(change(two_squares, "7 3 2", "7 4294967299 2"));
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  print_mesh<2>(two_squares);
  print_mesh<2>(one_square);
  print_mesh<3>(cube);
  print_mesh<2>(hinge);
  print_mesh<2>(slit);
  std::cout << std::endl;

  print_meshes_that_do_not_fit();
  print_damaged_files();
}
