// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "evaluation/solve_result.h"

namespace ElastoPlastic
{
  template <int dim>
  BodyState
  body_state(const SolidOperator<dim> &solid, const VectorType &displacement)
  {
    BodyState state;
    solid.for_each_cell(displacement, [&](const auto &, const auto &points) {
      for (const PointResult &point : points)
        {
          if (point.plastic)
            state.plastic_volume += point.volume;
          state.elastic_energy += point.elastic_energy * point.volume;
          state.hardening_energy += point.hardening_energy * point.volume;
          state.plastic_work += point.plastic_work * point.volume;
          state.dissipation += point.dissipation * point.volume;
          state.max_equivalent_plastic_strain =
            std::max(state.max_equivalent_plastic_strain,
                     point.equivalent_plastic_strain);
        }
    });

    const MPI_Comm communicator = displacement.get_mpi_communicator();
    for (double *const integral : {&state.plastic_volume,
                                   &state.elastic_energy,
                                   &state.hardening_energy,
                                   &state.plastic_work,
                                   &state.dissipation})
      *integral = Utilities::MPI::sum(*integral, communicator);
    state.max_equivalent_plastic_strain =
      Utilities::MPI::max(state.max_equivalent_plastic_strain, communicator);
    return state;
  }



  template BodyState
  body_state(const SolidOperator<2> &, const VectorType &);
  template BodyState
  body_state(const SolidOperator<3> &, const VectorType &);



  void
  MeanForce::add(SolveResult &result)
  {
    const double advance = result.depth - depth;
    if (advance * (depth - first_depth) < 0.)
      {
        first_depth = depth;
        work        = 0.;
      }
    work += 0.5 * (force + result.force) * advance;

    if (result.active_nodes != active_nodes && result.depth != first_depth)
      {
        result.mean_force = work / (result.depth - first_depth);
        result.mean_depth = 0.5 * (first_depth + result.depth);
        first_depth       = result.depth;
        work              = 0.;
      }
    depth        = result.depth;
    force        = result.force;
    active_nodes = result.active_nodes;
  }
} // namespace ElastoPlastic
