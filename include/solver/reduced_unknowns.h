// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_reduced_unknowns_h
#define solver_reduced_unknowns_h

#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <vector>

#include "base/shared_rows.h"
#include "base/sloped_bound.h"
#include "solver/held_unknowns.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Which unknowns of a system do not move on their own. Constrained ones do
  /// not move at all. Coupled ones move together, all by the same amount: the
  /// contact nodes under a rigid indenter whose depth is unknown too.
  ///
  /// Both may share the forces on them with entering unknowns b, whose openings
  /// w_b are free: then it is u_i - sum_b t_ib w_b, with the t_ib of
  /// SharedRows, that does not move, or moves with the others, and u_b + w_b -
  /// sum_c t_bc w_c for an entering one. In reduced vectors, -w_b stands for
  /// u_b.
  ///
  /// Bounds may be sloped: then u_i - sum_j b_j u_j stands for u_i in all this,
  /// with the slopes b_j of its bound. With friction, the forces on the bound
  /// have slopes of their own.
  ///
  /// A reduced vector is zero at constrained and coupled unknowns, but for the
  /// first of the coupled ones, the leader, which stands for all of them. With
  /// E, the expansion of reduced vectors, the reduced form of a symmetric
  /// matrix A is E^T A E: symmetric, and positive definite if A is. With
  /// friction, another matrix that has the slopes of the forces takes the place
  /// of E^T.
  class ReducedUnknowns
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// All unknowns are free.
    ReducedUnknowns() = default;

    /// @p constrained and @p coupled are indices of unknowns that this rank
    /// owns.
    ReducedUnknowns(const std::vector<unsigned int> &constrained,
                    const std::vector<unsigned int> &coupled,
                    const MPI_Comm                   communicator,
                    const SharedForces              &shared = {});

    /// Takes the slopes and curvatures of the bounds of active unknowns,
    /// entering ones included. To be called on all ranks or on none.
    void
    set_sloped_bounds(const std::vector<SlopedBound> &bounds);

    /// Whether there are coupled unknowns, on any rank.
    bool
    has_coupling() const
    {
      return leading_rank < Utilities::MPI::n_mpi_processes(communicator);
    }

    /// Whether the same unknowns are constrained, coupled and entering as in
    /// @p other, wherever their bounds are. Collective.
    bool
    are_held_as_in(const ReducedUnknowns &other) const;

    /// Whether expand() does nothing.
    bool
    is_trivial() const
    {
      return !has_coupling() && !shared.rows && !is_sloped;
    }

    /// Whether there may be entering unknowns.
    bool
    have_entering() const
    {
      return shared.rows != nullptr;
    }

    /// What they share with others.
    const SharedForces &
    shared_forces() const
    {
      return shared;
    }

    /// Whether bounds are sloped.
    bool
    have_slopes() const
    {
      return is_sloped;
    }

    /// Whether contract() multiplies by the transpose of expand(): not where
    /// there is friction.
    bool
    is_symmetric() const
    {
      return !has_friction;
    }

    /// Multiplies by E: gives all coupled unknowns the value of their leader,
    /// and all active ones what openings and slopes make of it.
    void
    expand(Vector &increment) const;

    /// Makes of the product of A with an @p expanded increment that of the
    /// reduced form with the @p reduced one: adds the parts of the tangent that
    /// come from the curvature of bounds, the turning of friction and the
    /// changes of what is shared, and contracts.
    void
    reduce_product(Vector       &forces,
                   const Vector &expanded,
                   const Vector &reduced) const;

    /// Multiplies by E^T, or what friction makes of it: entering unknowns keep
    /// what exceeds their share; the leader gets the sum of the coupled
    /// unknowns, constrained and other coupled ones zero.
    void
    contract(Vector &forces) const;

    /// Makes of the diagonal of A an approximation of that of E^T A E.
    void
    contract_diagonal(Vector &diagonal) const;

    /// Preconditioners have displacements for unknowns, not openings: makes of
    /// reduced @p forces those that belong to the displacements of entering
    /// unknowns, and of a reduced increment with these one with openings.
    void
    release_entering(Vector &forces) const;
    void
    bind_entering(Vector &increment) const;

    /// Of an expanded @p vector with the motion @p motion, makes a reduced one
    /// whose expansion is near it.
    void
    reduce_motion(Vector &vector, const double motion) const;

    /// The leader's value, on all ranks. There must be coupled unknowns.
    double
    leading_value(const Vector &vector) const;

    /// Makes the leader's value @p value and those of all other constrained and
    /// coupled unknowns zero.
    void
    set_leading_value(Vector &vector, const double value) const;

    /// Sets @p value at all constrained and coupled unknowns.
    void
    set_entries(Vector &vector, const double value) const;

    /// Sets the slopes of the bounds of constrained and coupled unknowns at the
    /// unknowns that they depend on.
    void
    set_slopes(Vector &vector) const;

    /// Sets the stiffnesses of entering unknowns.
    void
    set_springs(Vector &vector) const;

  private:
    std::vector<double>
    entering_values(const Vector &vector) const;

    bool
    owns_leader() const
    {
      return leading_rank == Utilities::MPI::this_mpi_process(communicator);
    }

    std::vector<unsigned int> constrained, coupled;
    SharedForces              shared;
    std::vector<SlopedBound>  sloped_bounds;
    /// Those of the bounds, and of the forces on them; of the bounds of
    /// entering unknowns, with the opposite sign.
    Slopes<double> slopes, force_slopes, entering_slopes;
    bool           is_sloped    = false;
    bool           has_friction = false;
    MPI_Comm       communicator = MPI_COMM_SELF;
    /// The rank that owns the leader, its first coupled unknown; the number of
    /// ranks if there are no coupled unknowns.
    unsigned int leading_rank = 1;
  };
} // namespace ElastoPlastic

#endif
