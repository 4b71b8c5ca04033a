// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The meshes of the equilibrium method, which the first rank gathers from all:
// the same as if it had the whole mesh to itself, number by number. What it
// makes of them, bounds and stresses, is its work alone, and tested on one
// rank.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>

#include "bounds/mesh/split_mesh.h"
#include "refine_where.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  template <int dim>
  using Mesh = parallel::distributed::Triangulation<dim>;



  /// The corners of a block refine twice towards the upper one, in which two
  /// materials meet.
  template <int dim>
  void
  make_mesh(Mesh<dim> &mesh)
  {
    Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      upper[d] = d + 1.;
    GridGenerator::subdivided_hyper_rectangle(
      mesh, std::vector<unsigned int>(dim, 4), lower, upper, true);
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(cell->center()[0] < 0.5 * upper[0] ? 0 : 1);
    for (unsigned int i = 0; i < 2; ++i)
      refine_where(mesh, [&](const auto &cell) {
        return cell->center().distance(upper) < 1.5 * cell->diameter();
      });
  }



  /// Whether two lists are as long, and their entries the same by @p is_same.
  template <typename List, typename Comparison>
  bool
  are_same(const List &list, const List &other, const Comparison &is_same)
  {
    return std::equal(
      list.begin(), list.end(), other.begin(), other.end(), is_same);
  }



  template <int dim>
  void
  compare(const SplitMesh<dim> &found, const SplitMesh<dim> &expected)
  {
    verify("there are cells", !found.cells.empty());
    verify("cells",
           are_same(found.cells,
                    expected.cells,
                    [](const auto &a, const auto &b) {
                      return a.id == b.id && a.material_id == b.material_id;
                    }));
    verify("vertices", found.vertices == expected.vertices);
    verify("simplices",
           are_same(found.simplices,
                    expected.simplices,
                    [](const auto &a, const auto &b) {
                      return a.vertices == b.vertices && a.cell == b.cell &&
                             a.unit_corners == b.unit_corners;
                    }));
    verify(
      "faces",
      are_same(found.faces, expected.faces, [](const auto &a, const auto &b) {
        return a.vertices == b.vertices && a.boundary_id == b.boundary_id;
      }));
  }



  template <int dim>
  void
  test()
  {
    Mesh<dim> alone(MPI_COMM_SELF), shared(MPI_COMM_WORLD);
    make_mesh(alone);
    make_mesh(shared);
    const auto expected = make_split_mesh(alone),
               found    = make_split_mesh(shared);
    output() << dim << "D" << std::endl;
    on_first_rank([&]() { compare(found, expected); });
    const unsigned int of_others =
      Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0 ?
        0 :
        found.cells.size();
    verify("others have nothing",
           Utilities::MPI::max(of_others, MPI_COMM_WORLD) == 0);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
