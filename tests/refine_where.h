// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_refine_where_h
#define tests_refine_where_h

#include <deal.II/grid/tria.h>

/// Divides the cells of which @p is_divided(cell) holds.
template <int dim, typename Predicate>
void
refine_where(dealii::Triangulation<dim> &mesh, const Predicate &is_divided)
{
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned() && is_divided(cell))
      cell->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
}

#endif
