// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/distributed/p4est_wrappers.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include "base/compatibility.h"
#include "multigrid/level_matching.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The ranks that own the children of a cell in @p mesh, or the cell itself
    /// if it has none there.
    template <int dim>
    std::set<unsigned int>
    owners_of_children(const CellId                                    &id,
                       const parallel::distributed::Triangulation<dim> &mesh)
    {
      namespace P4est = internal::p4est;
      constexpr unsigned int n_children =
        GeometryInfo<dim>::max_children_per_cell;
      typename P4est::types<dim>::quadrant quadrant, children[n_children];
      P4est::init_coarse_quadrant<dim>(quadrant);
      for (const auto child : id.get_child_indices())
        {
          P4est::init_quadrant_children<dim>(quadrant, children);
          quadrant = children[static_cast<unsigned int>(child)];
        }
      P4est::init_quadrant_children<dim>(quadrant, children);

      // deal.II takes p4est's tree as the identity of a coarse cell.
      const types::coarse_cell_id tree     = id.get_coarse_cell_id();
      const auto                  owner_of = [&](const auto &child) {
        return P4est::functions<dim>::comm_find_owner(
          const_cast<typename P4est::types<dim>::forest *>(mesh.get_p4est()),
          tree,
          &child,
          Utilities::MPI::this_mpi_process(communicator_of(mesh)));
      };
      // p4est numbers the cells of the ranks one after the other.
      const unsigned int     first  = owner_of(children[0]);
      const unsigned int     last   = owner_of(children[n_children - 1]);
      std::set<unsigned int> owners = {first, last};
      for (unsigned int c = 1; first != last && c < n_children - 1; ++c)
        owners.insert(owner_of(children[c]));
      return owners;
    }



    /// The values of the coarse shape functions at the nodes of a fine cell,
    /// where @p to_coarse maps the unit cell of the fine cell into that of the
    /// coarse one.
    template <int dim>
    FullMatrix<double>
    interpolation_matrix(
      const FiniteElement<dim>                            &fine,
      const FiniteElement<dim>                            &coarse,
      const std::function<Point<dim>(const Point<dim> &)> &to_coarse)
    {
      FullMatrix<double> matrix(fine.n_dofs_per_cell(),
                                coarse.n_dofs_per_cell());
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          if (fine.system_to_component_index(i).first ==
              coarse.system_to_component_index(j).first)
            matrix(i, j) =
              coarse.shape_value(j, to_coarse(fine.unit_support_point(i)));
      return matrix;
    }
  } // namespace



  template <int dim>
  LevelMatching<dim>::LevelMatching(const DoFHandler<dim> &fine,
                                    const Constraints     &fine_constraints,
                                    const DoFHandler<dim> &coarse,
                                    const Constraints     &coarse_constraints)
    : fine(fine)
    , fine_constraints(fine_constraints)
    , coarse(coarse)
    , coarse_constraints(coarse_constraints)
    , first_dof(fine.n_locally_owned_dofs() > 0 ?
                  *fine.locally_owned_dofs().begin() :
                  0)
    , fine_cells(fine.get_triangulation())
    , coarse_cells(coarse.get_triangulation())
    , has_row(fine.n_locally_owned_dofs(), false)
    , same_cell(interpolation_matrix<dim>(
        fine.get_fe(), coarse.get_fe(), [](const Point<dim> &x) { return x; }))
    , dofs(fine.get_fe().n_dofs_per_cell())
  {
    for (unsigned int c = 0; c < GeometryInfo<dim>::max_children_per_cell; ++c)
      from_parent.push_back(interpolation_matrix<dim>(
        fine.get_fe(), coarse.get_fe(), [c](const Point<dim> &x) {
          return GeometryInfo<dim>::child_to_cell_coordinates(x, c);
        }));

    const auto &fine_mesh =
      dynamic_cast<const Mesh &>(fine.get_triangulation());
    parents.resize(fine_cells.size());
    const unsigned int this_rank =
      Utilities::MPI::this_mpi_process(communicator_of(fine_mesh));

    std::map<unsigned int, std::vector<CoarseCell>> messages;
    for (const auto &cell : coarse.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const CoarseCell coarse_cell = describe(cell);
          for (const auto rank : owners_of_children(cell->id(), fine_mesh))
            if (rank == this_rank)
              match(coarse_cell);
            else
              messages[rank].push_back(coarse_cell);
        }
    for (const auto &[rank, received] :
         Utilities::MPI::some_to_some(communicator_of(fine_mesh), messages))
      for (const CoarseCell &coarse_cell : received)
        match(coarse_cell);
  }



  template <int dim>
  CoarseCell
  LevelMatching<dim>::describe(
    const typename DoFHandler<dim>::active_cell_iterator &cell) const
  {
    CoarseCell result = {cell->id().template to_binary<dim>(),
                         *coarse_cells.global_indices().begin() +
                           coarse_cells.number(*cell),
                         {}};
    std::vector<types::global_dof_index> coarse_dofs(
      coarse.get_fe().n_dofs_per_cell());
    cell->get_dof_indices(coarse_dofs);
    for (const auto dof : coarse_dofs)
      if (const auto *const masters =
            coarse_constraints.get_constraint_entries(dof))
        result.unknowns.push_back(*masters);
      else
        result.unknowns.push_back({{dof, 1.}});
    return result;
  }



  template <int dim>
  void
  LevelMatching<dim>::match(const CoarseCell &coarse_cell)
  {
    const auto cell =
      fine.get_triangulation().create_cell_iterator(CellId(coarse_cell.id));
    const FineCell fine_cell(&fine.get_triangulation(),
                             cell->level(),
                             cell->index(),
                             &fine);
    if (fine_cell->is_active())
      match(fine_cell, coarse_cell, same_cell, 1.f);
    else
      for (unsigned int c = 0; c < fine_cell->n_children(); ++c)
        match(fine_cell->child(c),
              coarse_cell,
              from_parent[c],
              1.f / fine_cell->n_children());
  }



  template <int dim>
  void
  LevelMatching<dim>::match(const FineCell           &fine_cell,
                            const CoarseCell         &coarse_cell,
                            const FullMatrix<double> &interpolation,
                            const float               share)
  {
    if (!fine_cell->is_active() || !fine_cell->is_locally_owned())
      return;
    const typename DoFHandler<dim>::active_cell_iterator active(fine_cell);
    parents[fine_cells.number(*active)] = {coarse_cell.index, share};

    active->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        const types::global_dof_index row = dofs[i] - first_dof;
        if (dofs[i] < first_dof || row >= has_row.size() || has_row[row] ||
            fine_constraints.is_constrained(dofs[i]))
          continue;
        has_row[row] = true;
        rows.push_back(row);
        for (unsigned int j = 0; j < interpolation.n(); ++j)
          if (std::abs(interpolation(i, j)) > 1e-10)
            for (const auto &[dof, weight] : coarse_cell.unknowns[j])
              entries.emplace_back(dof, interpolation(i, j) * weight);
        row_starts.push_back(entries.size());
      }
  }



  template class LevelMatching<2>;
  template class LevelMatching<3>;
} // namespace ElastoPlastic
