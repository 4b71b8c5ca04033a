// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_state_transfer_h
#define mechanics_state_transfer_h

#include <deal.II/distributed/cell_data_transfer.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_dgq.h>

#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  /// Takes the states of the material points from one mesh to the next.
  ///
  /// In a cell that is divided, the values at its points are taken for those of
  /// a polynomial, of the degree that they determine, which is evaluated at the
  /// points of the children; a cell that replaces its children gets the
  /// polynomial next to theirs in the mean square. Both leave the integral over
  /// a cell alone as long as it is a parallelogram in plane or in space, and
  /// tensors without trace; but the stresses may leave the yield surface
  /// (doc/theory, "Meshes that follow the contact").
  ///
  /// Where a cell is of another material than the one that it comes from, its
  /// points are virgin: it has no past as what it is.
  template <int dim>
  class StateTransfer
  {
  public:
    /// For QGauss<dim>(@p degree + 1). If there is only one material
    /// (@p n_materials), it is that of all cells, whatever their ids.
    /// @p triangulation must outlive this object.
    StateTransfer(
      const parallel::distributed::Triangulation<dim> &triangulation,
      const unsigned int                               degree,
      const unsigned int                               n_materials);

    /// Hands in the states before the mesh changes. @p states must live until
    /// then.
    void
    prepare(const CellStates &states);

    /// The states on the mesh that execute_coarsening_and_refinement() has
    /// made.
    CellStates
    take();

  private:
    using Cell = typename Triangulation<dim>::cell_iterator;

    /// Whether a child of @p cell is of the same material.
    bool
    keeps_material(const Cell &cell, const unsigned int child) const
    {
      return n_materials == 1 ||
             cell->child(child)->material_id() == cell->material_id();
    }

    std::vector<std::vector<double>>
    to_children(const Cell &cell, const std::vector<double> &parent) const;

    std::vector<double>
    to_parent(const Cell                             &cell,
              const std::vector<std::vector<double>> &children) const;

    const parallel::distributed::Triangulation<dim> &triangulation;
    const unsigned int                               n_materials;
    /// The polynomials that are one at one of the points.
    const FE_DGQArbitraryNodes<dim>                               polynomials;
    parallel::distributed::CellDataTransfer<dim, dim, CellStates> transfer;
  };
} // namespace ElastoPlastic

#endif
