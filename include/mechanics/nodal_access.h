// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_nodal_access_h
#define mechanics_nodal_access_h

#include <deal.II/matrix_free/hanging_nodes_internal.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <utility>
#include <vector>

#include "base/inlining.h"
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
  /// component by component.
  template <int dim, typename Number>
  class NodalAccess
  {
  public:
    using value_type = typename Number::value_type;

    /// For the elements of @p matrix_free, with @p n_nodes nodes; it must
    /// outlive this object or the next call.
    void
    reinit(const MatrixFree<dim, value_type, Number> &matrix_free,
           const unsigned int                         n_nodes)
    {
      const unsigned int n_batches = matrix_free.n_cell_batches();
      indices.assign(n_batches, nullptr);
      own_indices.clear();
      std::vector<std::pair<unsigned int, std::size_t>> with_own;
      std::vector<unsigned int>                         of_cells;
      const DoFInfo &dofs = matrix_free.get_dof_info();
      for (unsigned int batch = 0; batch < n_batches; ++batch)
        if (matrix_free.n_active_entries_per_cell_batch(batch) == n_lanes)
          {
            dofs.get_dof_indices_on_cell_batch(of_cells,
                                               batch,
                                               /* with_constraints = */ false);
            if (!are_in_packs(of_cells, n_nodes, *dofs.vector_partitioner))
              continue;
            if (has_constraints(batch, dofs))
              {
                with_own.emplace_back(batch, own_indices.size());
                for (unsigned int node = 0; node < n_nodes; ++node)
                  for (unsigned int lane = 0; lane < n_lanes; ++lane)
                    own_indices.push_back(
                      of_cells[dim * n_nodes * lane + node]);
              }
            else
              indices[batch] =
                &dofs.dof_indices_interleaved
                   [dofs.row_starts[batch * dim * n_lanes].first];
          }
      for (const auto &[batch, begin] : with_own)
        indices[batch] = &own_indices[begin];
    }

    /// Whether @p batch can be treated here: it has a cell in each lane, and no
    /// node at the very end of vectors, beyond which LanePacks would read.
    /// Otherwise there is FEEvaluation.
    bool
    covers(const unsigned int batch) const
    {
      return indices[batch] != nullptr;
    }

    /// The local entries of a vector begin at @p vector.
    template <unsigned int n_nodes>
    ELASTO_PLASTIC_ALWAYS_INLINE inline void
    read(Number *const           values,
         const value_type *const vector,
         const unsigned int      batch) const
    {
      const unsigned int *index = indices[batch];
      for (unsigned int node = 0; node < n_nodes; ++node, index += n_lanes)
        {
          typename Packs::Batches of_node;
          Packs::read(of_node, vector, index);
          for (unsigned int c = 0; c < dim; ++c)
            values[c * n_nodes + node] = of_node[c];
        }
    }

    template <unsigned int n_nodes>
    ELASTO_PLASTIC_ALWAYS_INLINE inline void
    add(value_type *const   vector,
        const Number *const values,
        const unsigned int  batch) const
    {
      const unsigned int *index = indices[batch];
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

    using Packs   = LanePacks<dim, Number>;
    using DoFInfo = internal::MatrixFreeFunctions::DoFInfo;

    /// Whether deal.II has other indices for the cells of @p batch than those
    /// of their own nodes.
    static bool
    has_constraints(const unsigned int batch, const DoFInfo &dofs)
    {
      if (dofs.index_storage_variants[DoFInfo::dof_access_cell][batch] !=
          DoFInfo::IndexStorageVariants::interleaved)
        return true;
      const auto &patterns = dofs.hanging_node_constraint_masks;
      for (unsigned int i = n_lanes * batch; i < n_lanes * (batch + 1); ++i)
        if (i < patterns.size() && patterns[i] !=
                                     internal::MatrixFreeFunctions::
                                       unconstrained_compressed_constraint_kind)
          return true;
      return false;
    }

    /// Whether the unknowns of each node follow each other, in vectors that are
    /// long enough. Of @p of_cells, those of one cell follow those of another,
    /// component by component.
    static bool
    are_in_packs(const std::vector<unsigned int>   &of_cells,
                 const unsigned int                 n_nodes,
                 const Utilities::MPI::Partitioner &layout)
    {
      const unsigned int n_entries =
        layout.locally_owned_size() + layout.n_ghost_indices();
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        for (unsigned int node = 0; node < n_nodes; ++node)
          {
            const unsigned int *index = &of_cells[dim * n_nodes * lane + node];
            if (*index + Packs::pack_size > n_entries)
              return false;
            for (unsigned int c = 1; c < dim; ++c)
              if (index[c * n_nodes] != *index + c)
                return false;
          }
      return true;
    }

    /// For each batch, where the vector has the first unknown of its nodes: of
    /// the first node in all lanes, of the second ...
    /// (Where constraints interfere, deal.II does not have them in this order.)
    std::vector<const unsigned int *> indices;
    std::vector<unsigned int>         own_indices;
  };
} // namespace ElastoPlastic

#endif
