// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What material points remember comes back, by points and by cells; points of
// batches about which nothing has been said are virgin, and stay so if they are
// told.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <vector>

#include "mechanics/point_history.h"
#include "verdict.h"

using namespace dealii;
using namespace ElastoPlastic;

int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using Number                     = PointHistory::Number;
  constexpr unsigned int n_batches = 3, n_points = 4, n_back_stresses = 2;
  const unsigned int     n_values =
    MaterialState<Number>::n_values(n_back_stresses);

  PointHistory history(n_back_stresses);
  history.reinit(n_batches, n_points);
  const MaterialState<Number> virgin(n_back_stresses);
  MaterialState<Number>       state(n_back_stresses);
  state.plastic_strain[0][1]      = Number(0.01);
  state.equivalent_plastic_strain = Number(0.02);
  state.back_stresses[1][2][2]    = Number(3.);
  verify("virgin", virgin.is_virgin() && !state.is_virgin());

  for (unsigned int q = 0; q < n_points; ++q)
    history.set_state(0, q, virgin);
  history.set_state(1, 2, state);
  verify("other batches and points are virgin",
         history.state(0, 2).is_virgin() && history.state(1, 1).is_virgin() &&
           history.state(2, 0).is_virgin());
  const MaterialState<Number> stored = history.state(1, 2);
  verify("point",
         stored.plastic_strain[0][1][0] == 0.01 &&
           stored.equivalent_plastic_strain[0] == 0.02 &&
           stored.back_stresses[1][2][2][0] == 3.);

  const unsigned int        lane = Number::size() - 1;
  const std::vector<double> cell = history.cell_values(1, lane);
  verify("cell",
         cell.size() == n_points * n_values &&
           std::count(cell.begin(), cell.end(), 0.) == n_points * n_values - 3);
  history.set_cell_values(2, lane, cell);
  history.set_cell_values(0, lane, std::vector<double>(cell.size(), 0.));
  verify("cell handed over", history.cell_values(2, lane) == cell);
  verify("virgin cell handed over",
         history.state(0, 0).is_virgin() && history.state(0, 2).is_virgin());

  history.set_state(1, 2, virgin);
  verify("forgotten", history.state(1, 2).is_virgin());
  history.reinit(n_batches, n_points);
  verify("virgin again", history.state(2, 2).is_virgin());
}
