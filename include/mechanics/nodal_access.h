// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_nodal_access_h
#define mechanics_nodal_access_h

#include <deal.II/matrix_free/hanging_nodes_internal.h>
#include <deal.II/matrix_free/matrix_free.h>

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
  /// for that as for all the rest of a product.
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
      indices.resize(matrix_free.n_cell_batches());
      for (unsigned int batch = 0; batch < indices.size(); ++batch)
        indices[batch] = nodes_of(batch, matrix_free.get_dof_info(), n_nodes);
    }

    /// Whether @p batch can be treated here: it has a cell in each lane, no
    /// constraints, and no node at the very end of vectors, beyond which
    /// LanePacks would read. Otherwise there is FEEvaluation.
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

    /// Null if the batch cannot be treated.
    static const unsigned int *
    nodes_of(const unsigned int batch,
             const DoFInfo     &dofs,
             const unsigned int n_nodes)
    {
      if (dofs.index_storage_variants[DoFInfo::dof_access_cell][batch] !=
          DoFInfo::IndexStorageVariants::interleaved)
        return nullptr;
      const auto &patterns = dofs.hanging_node_constraint_masks;
      for (unsigned int i = n_lanes * batch; i < n_lanes * (batch + 1); ++i)
        if (i < patterns.size() && patterns[i] !=
                                     internal::MatrixFreeFunctions::
                                       unconstrained_compressed_constraint_kind)
          return nullptr;
      const unsigned int *const first =
        &dofs.dof_indices_interleaved[dofs.row_starts[batch * dim * n_lanes]
                                        .first];
      for (unsigned int c = 1; c < dim; ++c)
        for (unsigned int i = 0; i < n_nodes * n_lanes; ++i)
          if (first[c * n_nodes * n_lanes + i] != first[i] + c)
            return nullptr;
      const auto        &vectors = *dofs.vector_partitioner;
      const unsigned int n_entries =
        vectors.locally_owned_size() + vectors.n_ghost_indices();
      for (unsigned int i = 0; i < n_nodes * n_lanes; ++i)
        if (first[i] + Packs::pack_size > n_entries)
          return nullptr;
      return first;
    }

    /// For each batch, where the vector has the first unknown of its nodes: of
    /// the first node in all lanes, of the second ...
    std::vector<const unsigned int *> indices;
  };
} // namespace ElastoPlastic

#endif
