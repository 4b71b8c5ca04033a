// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/cell_data_transfer.templates.h>

#include "mechanics/state_transfer.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Adds @p matrix times the @p values at all points (point by point, each
    /// with the same quantities) to @p result.
    void
    add_product(std::vector<double>       &result,
                const FullMatrix<double>  &matrix,
                const std::vector<double> &values)
    {
      const unsigned int n_quantities = values.size() / matrix.n();
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          for (unsigned int k = 0; k < n_quantities; ++k)
            result[i * n_quantities + k] +=
              matrix(i, j) * values[j * n_quantities + k];
    }
  } // namespace



  template <int dim>
  StateTransfer<dim>::StateTransfer(
    const parallel::distributed::Triangulation<dim> &triangulation,
    const unsigned int                               degree,
    const unsigned int                               n_materials)
    : triangulation(triangulation)
    , n_materials(n_materials)
    , polynomials(QGauss<1>(degree + 1))
    , transfer(
        triangulation,
        /* transfer_variable_size_data = */ false,
        [this](const Cell &cell, const std::vector<double> parent) {
          return to_children(cell, parent);
        },
        [this](const Cell &cell, const CellStates &children) {
          return to_parent(cell, children);
        })
  {}



  template <int dim>
  void
  StateTransfer<dim>::prepare(const CellStates &states)
  {
    transfer.prepare_for_coarsening_and_refinement(states);
  }



  template <int dim>
  CellStates
  StateTransfer<dim>::take()
  {
    CellStates states(triangulation.n_active_cells());
    transfer.unpack(states);
    return states;
  }



  template <int dim>
  std::vector<std::vector<double>>
  StateTransfer<dim>::to_children(const Cell                &cell,
                                  const std::vector<double> &parent) const
  {
    std::vector<std::vector<double>> children(
      GeometryInfo<dim>::max_children_per_cell,
      std::vector<double>(parent.size(), 0.));
    for (unsigned int child = 0; child < children.size(); ++child)
      if (keeps_material(cell, child))
        add_product(children[child],
                    polynomials.get_prolongation_matrix(child),
                    parent);
    return children;
  }



  // (deal.II's restriction matrices of discontinuous elements are those of the
  // projection; the contributions of the children are to be added.)
  template <int dim>
  std::vector<double>
  StateTransfer<dim>::to_parent(
    const Cell &cell, const std::vector<std::vector<double>> &children) const
  {
    std::vector<double> parent(children[0].size(), 0.);
    for (unsigned int child = 0; child < children.size(); ++child)
      if (keeps_material(cell, child))
        add_product(parent,
                    polynomials.get_restriction_matrix(child),
                    children[child]);
    return parent;
  }



  template class StateTransfer<2>;
  template class StateTransfer<3>;
} // namespace ElastoPlastic
