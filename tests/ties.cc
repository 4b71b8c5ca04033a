// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Which cells are refined does not depend on rounding: where errors of cells
// that mirror each other differ in their last digits, all of them are refined,
// or none.

#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <set>
#include <string>

#include "adaptivity/refinement.h"
#include "adaptivity/ties.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// Falls from the middle of the square, as for each of its eight parts.
  double
  error_at(const Point<2> &x)
  {
    const double a = std::abs(x[0]), b = std::abs(x[1]);
    return std::exp(-3. * std::max(a, b) - std::min(a, b));
  }



  /// Of a mesh of 4^@p n_refinements cells, those that are to be refined. The
  /// @p noise is another one in each place, and for each @p seed. Of errors
  /// below @p smallest, only some noise remains.
  std::set<std::string>
  refined_cells(const unsigned int n_refinements,
                const double       fraction,
                const double       smallest,
                const double       noise,
                const double       seed)
  {
    parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
    GridGenerator::hyper_cube(mesh, -1., 1.);
    mesh.refine_global(n_refinements);
    Vector<float> errors(mesh.n_active_cells());
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const Point<2> x      = cell->center();
        const double   error  = error_at(x);
        const double of_place = std::sin(seed * (7. * x[0] + 31. * x[1] + 1.));
        errors[cell->active_cell_index()] = error < smallest ?
                                              1e-16 * std::abs(of_place) :
                                              error * (1. + noise * of_place);
      }
    RefinementParameters parameters;
    parameters.refinement_fraction = fraction;
    parameters.coarsening_fraction = std::min(0.3, 1. - fraction);
    flag_cells(parameters, errors, /* accuracy = */ 3e-5, mesh);
    std::set<std::string> result;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned() && cell->refine_flag_set())
        result.insert(cell->id().to_string());
    return result;
  }



  /// Whether the same cells are refined for all seeds: @p n_expected.
  bool
  depends_on_errors_only(const unsigned int n_refinements,
                         const double       fraction,
                         const double       smallest,
                         const double       noise,
                         const unsigned int n_expected)
  {
    bool result = true;
    for (const double seed : {1., 2., 5., 11., 23.})
      {
        const auto cells =
          refined_cells(n_refinements, fraction, smallest, noise, seed);
        result =
          result &&
          Utilities::MPI::sum(cells.size(), MPI_COMM_WORLD) == n_expected &&
          !Utilities::MPI::logical_or(
            cells !=
              refined_cells(n_refinements, fraction, smallest, noise, 3.),
            MPI_COMM_WORLD);
      }
    return result;
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  verify("no candidates", n_ties(3., {}, 5, 0.1) == 0);
  verify("a jump at once", n_ties(3., {2., 2., 2.}, 5, 0.1) == 0);
  verify("two before a jump", n_ties(3., {2.9, 2.8, 2., 1.9}, 5, 0.1) == 2);
  verify("all the rest", n_ties(3., {2.9, 2.7, 2.6}, 5, 0.1) == 3);
  verify("too many: to the widest one",
         n_ties(3., {2.9, 2.7, 2.6}, 2, 0.1) == 1);
  verify("all alike", n_ties(1., {1., 1., 1., 1.}, 2, 0.1) == 0);

  // A tenth of the cells are 25, or 102; the errors of 8, or of 4 on a
  // diagonal, are alike.
  for (const double noise : {1e-5, 1e-6, 1e-7})
    for (const double smallest : {0., 0.1})
      {
        verify("256 cells",
               depends_on_errors_only(4, 0.1, smallest, noise, 32));
        verify("1024 cells",
               depends_on_errors_only(5, 0.1, smallest, noise, 104));
      }
  verify("errors that are noise do not count",
         depends_on_errors_only(5, 0.5, 0.4, 1e-6, 72));
  verify("a mesh of cells that are alike",
         depends_on_errors_only(1, 0.25, 0., 1e-6, 4));
}
