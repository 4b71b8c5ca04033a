// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/vector.hpp>

#include "base/compatibility.h"
#include "bounds/body/gathered_solution.h"
#include "mechanics/ghosted_copy.h"

namespace ElastoPlastic
{
  template <int dim>
  GatheredSolution<dim>::GatheredSolution(const DoFHandler<dim> &dof_handler,
                                          const VectorType      &displacement)
    : fe(dof_handler.get_fe())
  {
    const VectorType values = ghosted_copy(displacement, dof_handler);
    std::map<CellId, std::vector<double>> own;
    Vector<double>                        of_cell(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_values(values, of_cell);
          own[cell->id()].assign(of_cell.begin(), of_cell.end());
        }
    for (const auto &of_rank :
         Utilities::MPI::gather(communicator_of(dof_handler), own))
      of_cells.insert(of_rank.begin(), of_rank.end());
  }



  // The components have the same shape functions.
  template <int dim>
  Tensor<1, dim>
  GatheredSolution<dim>::value(const CellId     &cell,
                               const Point<dim> &unit_point) const
  {
    const std::vector<double> &values = of_cells.at(cell);
    const FiniteElement<dim>  &scalar = fe.base_element(0);
    std::vector<double>        shapes(scalar.n_dofs_per_cell());
    for (unsigned int i = 0; i < shapes.size(); ++i)
      shapes[i] = scalar.shape_value(i, unit_point);

    Tensor<1, dim> result;
    for (unsigned int i = 0; i < values.size(); ++i)
      {
        const auto [component, index] = fe.system_to_component_index(i);
        result[component] += values[i] * shapes[index];
      }
    return result;
  }



  template class GatheredSolution<2>;
  template class GatheredSolution<3>;
} // namespace ElastoPlastic
