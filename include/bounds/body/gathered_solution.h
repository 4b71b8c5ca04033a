// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef bounds_body_gathered_solution_h
#define bounds_body_gathered_solution_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/cell_id.h>

#include <map>
#include <vector>

#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A finite element solution of all ranks, on the first of them, which can
  /// evaluate it anywhere. The others have nothing.
  template <int dim>
  class GatheredSolution
  {
  public:
    /// Collective. @p dof_handler must live as long as this object.
    GatheredSolution(const DoFHandler<dim> &dof_handler,
                     const VectorType      &displacement);

    /// At a point of the unit cell of a cell.
    Tensor<1, dim>
    value(const CellId &cell, const Point<dim> &unit_point) const;

  private:
    const FiniteElement<dim>             &fe;
    std::map<CellId, std::vector<double>> of_cells; ///< by local unknowns
  };
} // namespace ElastoPlastic

#endif
