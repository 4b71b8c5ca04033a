// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// How many unknowns a mesh may have: as many as the user allows, and never more
// than indices of 32 bits can number; how many cells of a small mesh are
// refined.

#include <deal.II/grid/grid_generator.h>

#include "adaptivity/refinement.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// Of four, with this fraction.
  std::uint64_t
  n_cells_with(const double fraction)
  {
    parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_cube(mesh, 2);
    Vector<float> indicators(mesh.n_active_cells());
    for (unsigned int i = 0; i < indicators.size(); ++i)
      indicators[i] = 1. + i;
    RefinementParameters parameters;
    parameters.refinement_fraction = fraction;
    flag_cells(parameters, indicators, 1e-3, mesh);
    return n_cells_after_refinement(mesh);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  RefinementParameters parameters;
  parameters.check_first_mesh(1.9e9);
  verify("no limit of the user", parameters.allows(1.9e9));
  verify("2^31", !parameters.allows(2147483648.));
  verify("what 2^32 would wrap to 1", !parameters.allows(4294967297.));
  print_error("first mesh",
              [&]() { parameters.check_first_mesh(2147483648.); });

  parameters.max_unknowns = 1000;
  parameters.check_first_mesh(1000);
  verify("within the limit", parameters.allows(1000));
  verify("beyond the limit", !parameters.allows(1001));
  print_error("first mesh", [&]() { parameters.check_first_mesh(1001); });
  print_error("first mesh", [&]() { parameters.check_first_mesh(3e9); });

  verify("half of four cells", n_cells_with(0.5) == 2 + 2 * 4);
  verify("less than one of four cells: one", n_cells_with(0.1) == 3 + 4);
  verify("none of four cells", n_cells_with(0.) == 4);
}
