// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What simplices have in proportion to their volume, on finer and on coarser
// meshes: its sum, and where it is.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "bounds/mesh/density_transfer.h"
#include "refine_where.h"
#include "values_of_simplices.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  template <int dim>
  using Mesh = parallel::distributed::Triangulation<dim>;

  /// The volumes of the simplices that are in one half of the cube, and a
  /// hundredth of those in the other.
  template <int dim>
  std::vector<double>
  values_on(const SplitMesh<dim> &mesh)
  {
    return values_of_simplices<dim>(mesh, [](const Point<dim> &x) {
      return x[0] < 0.5 ? 1. : 0.01;
    });
  }

  double
  sum(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.);
  }

  double
  largest_difference(const std::vector<double> &a, const std::vector<double> &b)
  {
    double largest = 0;
    for (unsigned int i = 0; i < std::max(a.size(), b.size()); ++i)
      largest = std::max(largest, std::abs(a.at(i) - b.at(i)));
    return largest;
  }



  /// Cells that are refined twice on one side keep the density, and so does the
  /// mesh when it is as coarse as before; those that are put together over the
  /// middle get the mean.
  template <int dim>
  void
  test()
  {
    output() << dim << " dimensions" << std::endl;
    Mesh<dim> mesh(MPI_COMM_WORLD);
    GridGenerator::hyper_cube(mesh);
    mesh.refine_global(2);
    const SplitMesh<dim> coarse = make_split_mesh(mesh);
    for (unsigned int i = 0; i < 2; ++i)
      refine_where(mesh,
                   [](const auto &cell) { return cell->center()[0] < 0.3; });
    const SplitMesh<dim> fine = make_split_mesh(mesh);
    verify("finer", fine.simplices.size() > 2 * coarse.simplices.size());

    const std::vector<double> on_fine =
      DensityTransfer<dim>(coarse, values_on(coarse)).on(fine);
    verify("refined", largest_difference(on_fine, values_on(fine)), 1e-15);
    const std::vector<double> on_coarse =
      DensityTransfer<dim>(fine, values_on(fine)).on(coarse);
    verify("coarsened",
           largest_difference(on_coarse, values_on(coarse)),
           1e-15);

    Mesh<dim> one_cell(MPI_COMM_WORLD);
    GridGenerator::hyper_cube(one_cell);
    const SplitMesh<dim>      coarsest = make_split_mesh(one_cell);
    const std::vector<double> on_coarsest =
      DensityTransfer<dim>(fine, values_on(fine)).on(coarsest);
    verify("sum", std::abs(sum(on_coarsest) - sum(values_on(fine))), 1e-12);
    verify("mean density",
           std::abs(on_coarsest[0] /
                      volume(coarsest.corners(coarsest.simplices[0])) -
                    0.505),
           1e-12);
    verify("nothing known", DensityTransfer<dim>(coarse, {}).on(fine).empty());
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
