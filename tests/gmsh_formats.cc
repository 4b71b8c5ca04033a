// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What is made of mesh files that Gmsh writes beside the usual ones: elements
// of second order, partitioned meshes, no physical groups, older formats; and
// materials by the names of their groups.

#include <deal.II/base/mpi.h>

#include <iostream>
#include <set>

#include "gmsh_text.h"

using namespace ElastoPlastic;

namespace
{
  /// Two squares side by side, of second order; the middle of the lowest edge
  /// is off the line between the corners.
  const std::string second_order = R"($Comments
written by hand
$EndComments
$MeshFormat
2.1 0 8
$EndMeshFormat
$PhysicalNames
4
1 1 " foot: left, "
1 2 "lid: z"
2 7 "steel"
2 100112 "soft copper"
$EndPhysicalNames
$Nodes
13
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 0
7 0.5 0.1 0
8 1.5 0 0
9 0.5 1 0
10 1.5 1 0
11 0 0.5 0
12 1 0.5 0
13 2 0.5 0
$EndNodes
$Elements
5
1 8 2 1 1 1 2 7
2 8 2 2 2 6 5 10
3 8 2 2 2 5 4 9
4 16 2 7 1 1 2 5 4 7 12 9 11
5 16 2 100112 1 2 3 6 5 8 13 10 12
$EndElements
)";

  /// The same squares, each in a part of its own: curves 11 and 12 are what
  /// curve 1 has been divided into, 13 is the line between the parts. The group
  /// of the curve has the number of another one.
  const std::string partitioned = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 12 "foot"
2 8 "block"
$EndPhysicalNames
$Entities
0 1 1 0
1 0 0 0 2 0 0 1 12 0
3 0 0 0 2 1 0 1 8 1 1
$EndEntities
$PartitionedEntities
2
1
99 1
0 3 2 0
11 1 1 1 1 0 0 0 1 0 0 1 12 0
12 1 1 1 2 1 0 0 2 0 0 0 0
13 2 3 2 1 2 1 0 0 1 1 0 0 0
1 2 3 1 1 0 0 0 1 1 0 1 8 1 11
2 2 3 1 2 1 0 0 2 1 0 1 8 1 12
$EndPartitionedEntities
$Nodes
1 6 1 6
2 1 0 6
1
2
3
4
5
6
0 0 0
1 0 0
2 0 0
0 1 0
1 1 0
2 1 0
$EndNodes
$Elements
5 5 1 5
1 11 1 1
1 1 2
1 12 1 1
2 2 3
1 13 1 1
3 2 5
2 1 3 1
4 1 2 5 4
2 2 3 1
5 2 3 6 5
$EndElements
)";



  template <int dim>
  void
  print_mesh(const std::string &text, const GmshFileParameters &parameters = {})
  {
    Triangulation<dim>  mesh;
    const BoundaryNames names = make_mesh_from_text(text, mesh, parameters);
    for (const auto &cell : mesh.active_cell_iterators())
      std::cout << "cell: centre " << cell->center() << ", measure "
                << cell->measure() << ", material " << cell->material_id()
                << std::endl;
    for (const auto &[name, id] : names)
      {
        double measure = 0;
        for (const auto &cell : mesh.active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() == id)
              measure += face->measure();
        std::cout << "boundary '" << name << "', number " << id << ": measure "
                  << measure << std::endl;
      }
    std::cout << std::endl;
  }



  GmshFileParameters
  with_groups(const std::vector<std::string> &groups)
  {
    GmshFileParameters parameters;
    parameters.material_groups = groups;
    return parameters;
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string without_comma =
    change(second_order, " foot: left, ", " foot: left ");
  print_mesh<2>(without_comma);
  print_mesh<2>(without_comma, with_groups({"soft copper", "steel"}));
  print_mesh<2>(change(without_comma, "2 7 \"steel\"", "2 7 \" \""),
                with_groups({"soft copper", "7"}));
  print_mesh<2>(partitioned);

  std::string without_groups = change(without_comma, "8 2 1 1", "8 2 0 1");
  without_groups             = change(without_groups, "8 2 2 2", "8 2 0 2");
  without_groups             = change(without_groups, "8 2 2 2", "8 2 0 3");
  print_mesh<2>(without_groups);

  print_error<2>(second_order);
  print_error<2>(without_comma, with_groups({"steel"}));
  print_error<2>(without_comma, with_groups({"steel", "copper"}));
  print_error<2>(without_comma, with_groups({"steel", "steel", "soft copper"}));
  print_error<2>(change(without_comma, "2 5 4 7 12", "2 4 5 7 12"));
}
