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

  /// The conditions of active unknowns k that share their forces with unknowns
  /// j that are not: sum_j t_kj u_j comes on top of u_k, and of a force f_k on
  /// u_k, u_j takes the part t_kj f_k. Columns of active unknowns count as
  /// zero.
  class SharedRows
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// A sparse matrix most of whose rows are zero: these are not stored.
    class Weights
    {
    public:
      struct Entry
      {
        types::global_dof_index row, column;
        double                  value;
      };

      /// The sum of the @p entries of all ranks. Each rank has its rows and
      /// columns in @p layout, as its own or as ghosts.
      Weights(const std::vector<Entry>                                 &entries,
              const std::shared_ptr<const Utilities::MPI::Partitioner> &layout);

      /// Two vectors with the partition of the layout, and no ghost values.
      /// Collective.
      void
      vmult(Vector &result, const Vector &vector) const;

      /// The same for the transpose. Collective.
      void
      Tvmult(Vector &result, const Vector &vector) const;

    private:
      NodalInterpolation<1, double> rows;
    };

    /// t_kj = @p scale_k * @p weights_kj. There are ones in @p active at the
    /// active unknowns, zeros elsewhere.
    SharedRows(const std::shared_ptr<const Weights> &weights,
               const std::shared_ptr<const Vector>  &scale,
               const Vector                         &active);

    /// sum_j t_kj u_j at all unknowns k that have a row, active or not.
    /// Collective.
    Vector
    sums(const Vector &u) const;

    /// sum_k t_kj f_k of the active k, at the unknowns that are not active;
    /// zero elsewhere. Collective.
    Vector
    shares(const Vector &forces) const;

  private:
    std::shared_ptr<const Weights> weights;
    std::shared_ptr<const Vector>  scale;
    Vector                         active;
  };
} // namespace ElastoPlastic

#endif
