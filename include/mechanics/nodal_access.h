// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_nodal_access_h
#define mechanics_nodal_access_h

#include <deal.II/matrix_free/matrix_free.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/lane_packs.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Reads and adds to the entries of a vector that belong to the nodes of a
  /// batch of cells. deal.II's FEEvaluation does that unknown by unknown, in
  /// each lane; but the unknowns of a node follow each other in the vector, so
  /// that they can be read and written together. Small elements need as long
  /// for that as for all the rest of a product. Constraints are left to
  /// EliminatedUnknowns.
  ///
  /// The numbers of a batch are those of FEEvaluation::begin_dof_values():
  /// component by component. Lanes without a cell read zeros, and add nothing.
  template <int dim, typename Number>
  class NodalAccess
  {
  public:
    using value_type = typename Number::value_type;

    /// For the elements of @p matrix_free, with @p n_nodes nodes. (Not by its
    /// indices, which put the master in the place of an unknown that is equal
    /// to it.) One index for each node takes the place of those of all unknowns
    /// in @p matrix_free, two for each, which are released: from now on, it
    /// cannot read or write vectors.
    void
    reinit(MatrixFree<dim, value_type, Number> &matrix_free,
           const unsigned int                   n_nodes)
    {
      const unsigned int n_batches = matrix_free.n_cell_batches();
      const auto        &layout    = *matrix_free.get_vector_partitioner();
      const unsigned int n_entries =
        layout.locally_owned_size() + layout.n_ghost_indices();
      n_indices = n_nodes * n_lanes;
      n_cells.resize(n_batches);
      packs_fit.resize(n_batches);
      indices.assign(n_batches * n_indices, 0);
      const auto &numbering =
        matrix_free.get_shape_info().lexicographic_numbering;
      std::vector<types::global_dof_index> dofs(dim * n_nodes);
      for (unsigned int batch = 0; batch < n_batches; ++batch)
        {
          n_cells[batch] = matrix_free.n_active_entries_per_cell_batch(batch);
          unsigned int *const index = &indices[batch * n_indices];
          for (unsigned int lane = 0; lane < n_cells[batch]; ++lane)
            {
              matrix_free.get_cell_iterator(batch, lane)->get_dof_indices(dofs);
              for (unsigned int node = 0; node < n_nodes; ++node)
                index[node * n_lanes + lane] =
                  layout.global_to_local(first_unknown(dofs, node, numbering));
            }
          packs_fit[batch] =
            n_cells[batch] == n_lanes &&
            *std::max_element(index, index + n_indices) + Packs::pack_size <=
              n_entries;
        }
      release_indices(matrix_free);
    }

    /// The local entries of a vector begin at @p vector. (Not inlined, since
    /// kernels call it in many places.)
    template <unsigned int n_nodes>
    [[gnu::noinline]] void
    read(Number *const           values,
         const value_type *const vector,
         const unsigned int      batch) const
    {
      const unsigned int *index = &indices[batch * n_indices];
      if (!packs_fit[batch])
        {
          for (unsigned int node = 0; node < n_nodes; ++node, index += n_lanes)
            for (unsigned int c = 0; c < dim; ++c)
              {
                Number &value = values[c * n_nodes + node];
                value         = 0.;
                for (unsigned int lane = 0; lane < n_cells[batch]; ++lane)
                  value[lane] = vector[index[lane] + c];
              }
          return;
        }
      for (unsigned int node = 0; node < n_nodes; ++node, index += n_lanes)
        {
          typename Packs::Batches of_node;
          Packs::read(of_node, vector, index);
          for (unsigned int c = 0; c < dim; ++c)
            values[c * n_nodes + node] = of_node[c];
        }
    }

    template <unsigned int n_nodes>
    [[gnu::noinline]] void
    add(value_type *const   vector,
        const Number *const values,
        const unsigned int  batch) const
    {
      const unsigned int *index = &indices[batch * n_indices];
      if (!packs_fit[batch])
        {
          for (unsigned int node = 0; node < n_nodes; ++node, index += n_lanes)
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int lane = 0; lane < n_cells[batch]; ++lane)
                vector[index[lane] + c] += values[c * n_nodes + node][lane];
          return;
        }
      for (unsigned int node = 0; node < n_nodes; ++node, index += n_lanes)
        {
          typename Packs::Batches of_node;
          for (unsigned int c = 0; c < dim; ++c)
            of_node[c] = values[c * n_nodes + node];
          Packs::add(vector, of_node, index);
        }
    }

  private:
    static constexpr unsigned int n_lanes = Number::size();

    using Packs = LanePacks<dim, Number>;

    /// The first unknown of a node of a cell with these @p dofs; the others
    /// follow it.
    static types::global_dof_index
    first_unknown(const std::vector<types::global_dof_index> &dofs,
                  const unsigned int                          node,
                  const std::vector<unsigned int>            &numbering)
    {
      const unsigned int n_nodes = dofs.size() / dim;
      const auto         first   = dofs[numbering[node]];
      for (unsigned int c = 1; c < dim; ++c)
        AssertThrow(dofs[numbering[c * n_nodes + node]] == first + c,
                    ExcInternalError());
      return first;
    }

    /// (There is no other access to them.)
    static void
    release_indices(MatrixFree<dim, value_type, Number> &matrix_free)
    {
      auto &dofs = const_cast<internal::MatrixFreeFunctions::DoFInfo &>(
        matrix_free.get_dof_info());
      for (auto *list : {&dofs.dof_indices,
                         &dofs.dof_indices_interleaved,
                         &dofs.plain_dof_indices,
                         &dofs.row_starts_plain_indices})
        std::vector<unsigned int>().swap(*list);
      std::vector<std::pair<unsigned int, unsigned int>>().swap(
        dofs.row_starts);
    }

    /// Of a batch, n_lanes for each node.
    std::size_t n_indices = 0;
    /// For each batch, where the vector has the first unknown of its nodes: of
    /// the first node in all lanes, of the second ...
    std::vector<unsigned int> indices;
    /// For each batch the number of its cells, and whether it has a cell in
    /// each lane and no node at the very end of vectors, beyond which LanePacks
    /// would read.
    std::vector<unsigned char> n_cells, packs_fit;
  };
} // namespace ElastoPlastic

#endif
