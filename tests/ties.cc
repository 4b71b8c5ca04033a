// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Which cells are refined and put together does not depend on rounding: where
// errors of cells that mirror each other differ in their last digits, both are
// flagged, or none.

#include <deal.II/grid/grid_generator.h>

#include <set>

#include "adaptivity/refinement.h"
#include "adaptivity/ties.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  constexpr double noise = 1e-5;



  /// Falls from the middle of the square, as for each of its eight parts.
  double
  error_at(const Point<2> &x)
  {
    const double a = std::abs(x[0]), b = std::abs(x[1]);
    return std::exp(-3. * std::max(a, b) - std::min(a, b));
  }



  /// Numbers of cells that are to be refined, and of those to be put together,
  /// as if they were to be seen in a mirror. The noise is another one in each
  /// place, and for each @p seed.
  std::pair<std::set<std::string>, std::set<std::string>>
  flagged_cells(const double seed)
  {
    parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
    GridGenerator::hyper_cube(mesh, -1., 1.);
    mesh.refine_global(4);
    Vector<float> errors(mesh.n_active_cells());
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const Point<2> x = cell->center();
        errors[cell->active_cell_index()] =
          error_at(x) *
          (1. + noise * std::sin(seed * (7. * x[0] + 31. * x[1] + 1.)));
      }
    RefinementParameters parameters;
    parameters.refinement_fraction = 0.1;
    parameters.coarsening_fraction = 0.21;
    flag_cells(parameters, errors, 3. * noise, mesh);
    std::pair<std::set<std::string>, std::set<std::string>> result;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          if (cell->refine_flag_set())
            result.first.insert(cell->id().to_string());
          if (cell->coarsen_flag_set())
            result.second.insert(cell->id().to_string());
        }
    return result;
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  verify("no candidates", n_ties(3., {}, 0.1) == 0);
  verify("a jump at once", n_ties(3., {2., 2., 2.}, 0.1) == 0);
  verify("two before a jump", n_ties(3., {2.9, 2.8, 2., 1.9}, 0.1) == 2);
  verify("no jump: the widest one", n_ties(3., {2.9, 2.7, 2.6}, 0.1) == 1);
  verify("nothing but ties: none", n_ties(0., {0., 0.}, 0.1) == 0);
  verify("errors from below", n_ties(-1., {-1.01, -2., -2.01}, 0.1) == 1);

  const auto cells = flagged_cells(1.);
  for (const double seed : {2., 5., 11., 23.})
    verify("other digits",
           !Utilities::MPI::logical_or(flagged_cells(seed) != cells,
                                       MPI_COMM_WORLD));
  const auto n_on_all_ranks = [](const std::set<std::string> &own) {
    return Utilities::MPI::sum(own.size(), MPI_COMM_WORLD);
  };
  verify("whole families of images are refined",
         n_on_all_ranks(cells.first) % 4 == 0 &&
           n_on_all_ranks(cells.first) > 24);
  verify("and are put together",
         n_on_all_ranks(cells.second) % 4 == 0 &&
           n_on_all_ranks(cells.second) > 0);
}
