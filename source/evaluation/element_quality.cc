// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <array>
#include <limits>

#include "base/compatibility.h"
#include "evaluation/element_quality.h"
#include "mechanics/ghosted_copy.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim>
    using Corners =
      std::array<Point<dim>, GeometryInfo<dim>::vertices_per_cell>;



    /// (The neighbours of a vertex differ from it in one bit of its number.)
    template <int dim>
    double
    scaled_jacobian(const Corners<dim> &corners, const unsigned int v)
    {
      Tensor<2, dim> edges;
      double         lengths = 1;
      for (unsigned int d = 0; d < dim; ++d)
        {
          edges[d] = corners[v | (1U << d)] - corners[v & ~(1U << d)];
          lengths *= edges[d].norm();
        }
      return lengths > 0 ? determinant(edges) / lengths : 0.;
    }
  } // namespace



  template <int dim>
  ElementQuality<dim>
  worst_element(const DoFHandler<dim>                            &dof_handler,
                const LinearAlgebra::distributed::Vector<double> &displacement)
  {
    const auto          ghosted_u    = ghosted_copy(displacement, dof_handler);
    const MPI_Comm      communicator = communicator_of(dof_handler);
    ElementQuality<dim> worst        = {std::numeric_limits<double>::max(), {}};
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          Corners<dim> corners;
          for (const unsigned int v : cell->vertex_indices())
            {
              corners[v] = cell->vertex(v);
              for (unsigned int d = 0; d < dim; ++d)
                corners[v][d] += ghosted_u(cell->vertex_dof_index(v, d));
            }
          for (const unsigned int v : cell->vertex_indices())
            if (const double value = scaled_jacobian<dim>(corners, v);
                value < worst.scaled_jacobian)
              worst = {value, corners[v]};
        }
    const auto least =
      Utilities::MPI::min_max_avg(worst.scaled_jacobian, communicator);
    return {least.min,
            Utilities::MPI::broadcast(communicator,
                                      worst.place,
                                      least.min_index)};
  }



  template ElementQuality<2>
  worst_element(const DoFHandler<2> &,
                const LinearAlgebra::distributed::Vector<double> &);
  template ElementQuality<3>
  worst_element(const DoFHandler<3> &,
                const LinearAlgebra::distributed::Vector<double> &);
} // namespace ElastoPlastic
