// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_held_unknowns_h
#define solver_held_unknowns_h

#include <deal.II/lac/la_parallel_vector.h>

#include <vector>

#include "base/shared_rows.h"
#include "solver/tangent_operator.h"

namespace ElastoPlastic
{
  /// Unknowns i that move along slopes as others do: u_i by sum_j b_ij u_j. All
  /// of them belong to this rank.
  template <typename Number>
  class Slopes
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<Number>;

    /// Lets u_i move by @p slope times u_j, too.
    void
    add(const unsigned int i, const unsigned int j, const Number slope)
    {
      entries.push_back({i, j, slope});
    }

    bool
    empty() const
    {
      return entries.empty();
    }

    void
    expand(Vector &u) const
    {
      for (const auto &[i, j, slope] : entries)
        u.local_element(i) += slope * u.local_element(j);
    }

    /// The transpose: adds the forces on u_i to those along the slopes.
    void
    contract(Vector &forces) const
    {
      for (const auto &[i, j, slope] : entries)
        forces.local_element(j) += slope * forces.local_element(i);
    }

    /// The diagonal of a contracted and expanded matrix with this @p diagonal,
    /// without what couples the two.
    void
    contract_diagonal(Vector &diagonal) const
    {
      for (const auto &[i, j, slope] : entries)
        diagonal.local_element(j) += slope * slope * diagonal.local_element(i);
    }

  private:
    struct Entry
    {
      unsigned int i, j;
      Number       slope;
    };
    std::vector<Entry> entries;
  };



  /// The unknowns that a preconditioner holds, and those that springs hold.
  struct HeldUnknowns
  {
    /// Ones at those that this rank owns, zeros elsewhere.
    VectorType constrained;
    /// Those whose bounds are sloped are not held at their place, but at sum_j
    /// b_j u_j, with the unknowns of the same node: here are the b_j, at these
    /// (for_each_slope()). Without size if no bound is sloped.
    VectorType slopes;
    /// The stiffnesses of the springs, which add to the diagonal. Without size
    /// if there are none.
    VectorType springs = {};
    /// Those that are held move against those that share their forces, as far
    /// as a preconditioner can take account of it.
    SharedForces shared = {};
  };



  /// Calls visit(j, b_j) for the slopes of the held unknown @p i that are not
  /// zero, with value_at(j) of HeldUnknowns::slopes. (The unknowns of a node
  /// are consecutive, and the one that is held on a slope is the last.)
  template <int dim, typename Index, typename ValueAt, typename Visit>
  void
  for_each_slope(const Index i, const ValueAt &value_at, const Visit &visit)
  {
    if (i % dim == dim - 1)
      for (Index j = i - (dim - 1); j < i; ++j)
        if (const auto slope = value_at(j); slope != 0)
          visit(j, slope);
  }
} // namespace ElastoPlastic

#endif
