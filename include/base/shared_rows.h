// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_shared_rows_h
#define base_shared_rows_h

#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <vector>

#include "base/nodal_interpolation.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A sparse matrix t_ij on a few unknowns of vectors of many, most of whose
  /// rows are zero: of the conditions of unknowns i that share their forces
  /// with others, j.
  ///
  /// The few have a numbering of their own, with a partition of its own.
  class SharedRows
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;
    using Rows   = NodalInterpolation<1, double>;

    /// @p rows are those of this rank by number, with the columns as entries of
    /// vectors with the partition @p layout of the numbers; entries[k] is the
    /// place of the number k of this rank in vectors of all unknowns.
    SharedRows(const Rows                      &rows,
               const std::vector<unsigned int> &entries,
               const std::shared_ptr<const Utilities::MPI::Partitioner> &layout)
      : rows(rows)
      , entries(entries)
      , few(layout)
    {}

    /// Calls receive(i, sum_j t_ij u_j) for the unknowns i of this rank that
    /// have a row, in the order of their numbers, when u is no longer needed.
    /// Collective.
    template <typename Number, typename Receive>
    void
    sums(const LinearAlgebra::distributed::Vector<Number> &u,
         const Receive                                    &receive) const
    {
      for (unsigned int k = 0; k < entries.size(); ++k)
        few.local_element(k) = u.local_element(entries[k]);
      few.update_ghost_values();
      rows.interpolate(few.begin(),
                       [&](const unsigned int k, const double value) {
                         receive(entries[k], value);
                       });
      few.zero_out_ghost_values();
    }

    /// Calls receive(j, sum_i t_ij f_i) for all few unknowns of this rank, in
    /// the order of their numbers, when f is no longer needed. Collective.
    template <typename Number, typename Receive>
    void
    shares(const LinearAlgebra::distributed::Vector<Number> &f,
           const Receive                                    &receive) const
    {
      few = 0.;
      rows.add_transpose(few.begin(), [&](const unsigned int k) {
        return f.local_element(entries[k]);
      });
      few.compress(VectorOperation::add);
      for (unsigned int k = 0; k < entries.size(); ++k)
        receive(entries[k], few.local_element(k));
    }

    struct Entry
    {
      types::global_dof_index row, column;
      double                  value;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /* version */)
      {
        archive &row &column &value;
      }
    };

    /// The entries in the rows of this rank, with the global indices of vectors
    /// of all unknowns, which have this @p layout. Collective.
    std::vector<Entry>
    global_entries(const Utilities::MPI::Partitioner &layout) const
    {
      // (Indices are exact as numbers of double precision.)
      for (unsigned int k = 0; k < entries.size(); ++k)
        few.local_element(k) = layout.local_to_global(entries[k]);
      few.update_ghost_values();
      const auto index = [&](const unsigned int k) {
        return static_cast<types::global_dof_index>(few.local_element(k));
      };
      std::vector<Entry> result;
      rows.for_each_entry(
        [&](const unsigned int i, const unsigned int j, const double value) {
          result.push_back({index(i), index(j), value});
        });
      few.zero_out_ghost_values();
      return result;
    }

  private:
    const Rows                      rows;
    const std::vector<unsigned int> entries;
    mutable Vector                  few;
  };


  /// An unknown u_b that comes under a bound as an opening w_b shrinks, and
  /// shares the forces of others meanwhile: that of a node which is entering
  /// the contact. Its reduced form is the change of -w_b.
  struct EnteringUnknown
  {
    unsigned int index;
    /// By how much its share of forces falls with w_b.
    double stiffness;
  };



  /// Unknowns that share their forces with entering ones.
  struct SharedForces
  {
    /// t_jb, with the entering unknowns b; null if there are none.
    std::shared_ptr<const SharedRows> rows;
    /// In the order of their numbers.
    std::vector<EnteringUnknown> entering;
  };
} // namespace ElastoPlastic

#endif
