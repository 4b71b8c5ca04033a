// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_reduced_unknowns_h
#define solver_reduced_unknowns_h

#include <deal.II/lac/la_parallel_vector.h>

#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Which unknowns of a system do not move on their own. Held ones do not move
  /// at all. Tied ones move together, all by the same amount: the contact nodes
  /// under a rigid indenter whose depth is unknown too.
  ///
  /// A reduced vector is zero at held and tied unknowns, but for the first of
  /// the tied ones, the leader, which stands for all of them. With E, the
  /// expansion of reduced vectors, the reduced form of a symmetric matrix A is
  /// E^T A E: symmetric, and positive definite if A is.
  class ReducedUnknowns
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// All unknowns are free.
    ReducedUnknowns() = default;

    /// @p held and @p tied are indices of unknowns that this rank owns.
    ReducedUnknowns(const std::vector<unsigned int> &held,
                    const std::vector<unsigned int> &tied,
                    const MPI_Comm                   communicator);

    /// Whether there are tied unknowns, on any rank.
    bool
    has_ties() const;

    /// Multiplies by E: gives all tied unknowns the value of their leader.
    void
    expand(Vector &increment) const;

    /// Multiplies by E^T: the leader gets the sum of the tied unknowns, held
    /// and other tied ones zero.
    void
    contract(Vector &forces) const;

    /// The leader's value, on all ranks. There must be tied unknowns.
    double
    leading_value(const Vector &vector) const;

    /// Makes the leader's value @p value and those of all other held and tied
    /// unknowns zero.
    void
    set_leading_value(Vector &vector, const double value) const;

    /// Sets @p value at all held and tied unknowns.
    void
    set_entries(Vector &vector, const double value) const;

  private:
    bool
    owns_leader() const;

    std::vector<unsigned int> held, tied;
    MPI_Comm                  communicator = MPI_COMM_SELF;
    /// The rank that owns the leader, its first tied unknown; the number of
    /// ranks if there are no tied unknowns.
    unsigned int leading_rank = 1;
  };
} // namespace ElastoPlastic

#endif
