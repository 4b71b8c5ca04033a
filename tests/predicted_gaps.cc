// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What cells add to the gap of two bounds: as it is on their own mesh, and as
// it is predicted on finer ones, the same on any number of ranks.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <utility>
#include <vector>

#include "bounds/mesh/predicted_gaps.h"
#include "values_of_simplices.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  template <int dim>
  using Mesh = parallel::distributed::Triangulation<dim>;

  bool
  are_equal(const double a, const double b)
  {
    return std::abs(a - b) < 1e-6; // indicators are of single precision
  }



  double
  sum_of_gaps(const Vector<float> &indicators)
  {
    return Utilities::MPI::sum<double>(indicators.norm_sqr(), MPI_COMM_WORLD);
  }



  /// Where the cell of the largest gap is.
  template <int dim>
  Point<dim>
  place_of_largest(const Mesh<dim> &mesh, const Vector<float> &indicators)
  {
    double     largest = -1;
    Point<dim> place;
    for (const auto &cell : mesh.active_cell_iterators())
      if (const double gap = indicators[cell->active_cell_index()];
          cell->is_locally_owned() && gap > largest)
        {
          largest = gap;
          place   = cell->center();
        }
    for (const auto &[gap, of_rank] :
         Utilities::MPI::all_gather(MPI_COMM_WORLD, std::pair(largest, place)))
      if (gap > largest)
        {
          largest = gap;
          place   = of_rank;
        }
    return place;
  }



  template <int dim>
  void
  test()
  {
    output() << dim << "D" << std::endl;
    Mesh<dim> mesh(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_cube(mesh, 2);
    const auto split = make_split_mesh(mesh);

    const PredictedGaps<dim> even(
      split,
      values_of_simplices<dim>(split, [](const auto &) { return 1.; }),
      MPI_COMM_WORLD);
    const auto at_corner = [](const Point<dim> &x) {
      return 1. / x.norm_square();
    };
    const PredictedGaps<dim> peak(split,
                                  values_of_simplices<dim>(split, at_corner),
                                  MPI_COMM_WORLD);
    const double             all = sum_of_gaps(peak.indicators(mesh));

    verify("own mesh", are_equal(sum_of_gaps(even.indicators(mesh)), 1.));
    for (double part : {0.5, 0.25})
      {
        mesh.refine_global(1);
        const Vector<float> indicators = even.indicators(mesh);
        bool                are_alike  = true;
        for (const auto &cell : mesh.active_cell_iterators())
          if (cell->is_locally_owned())
            are_alike =
              are_alike && are_equal(Utilities::fixed_power<2>(
                                       indicators[cell->active_cell_index()]),
                                     part * cell->measure());
        verify("half of it after each refinement, evenly",
               Utilities::MPI::min(are_alike ? 1 : 0, MPI_COMM_WORLD) == 1);
        verify("half of the peak",
               are_equal(sum_of_gaps(peak.indicators(mesh)) / all, part));
        output() << "largest at the corner: "
                 << place_of_largest(mesh, peak.indicators(mesh)) << std::endl;
      }
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
