// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_eliminated_unknowns_h
#define mechanics_eliminated_unknowns_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <vector>

#include "base/nodal_interpolation.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Unknowns that are combinations of others, their masters: those of hanging
  /// nodes and of skew rollers. deal.II's FEEvaluation interpolates them on
  /// each cell that has them. Here, a vector gets them all before a loop over
  /// cells, and hands their forces to their masters after it, so that the loop
  /// treats all cells alike.
  template <int dim, typename Number>
  class EliminatedUnknowns
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<Number>;

    /// Those of @p constraints that are entries of vectors with the @p layout,
    /// owned or ghosts. So must be their masters.
    void
    reinit(const AffineConstraints<double>   &constraints,
           const Utilities::MPI::Partitioner &layout);

    /// Sets the eliminated entries of @p vector, whose ghosts must be those of
    /// their owners, to what follows from their masters, and remembers what
    /// they were.
    void
    expand(Vector &vector) const;

    /// Undoes expand().
    void
    restore(Vector &vector) const;

    /// The transpose of expand(): adds the eliminated entries of @p forces to
    /// those of their masters, and makes them zero. (To be called before
    /// Vector::compress(): each rank does so with what its cells added.)
    void
    condense(Vector &forces) const;

  private:
    /// Of local indices.
    NodalInterpolation<dim, Number> interpolation;
    mutable std::vector<Number>     remembered;
  };
} // namespace ElastoPlastic

#endif
