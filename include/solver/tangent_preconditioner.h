// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_tangent_preconditioner_h
#define solver_tangent_preconditioner_h

#include <deal.II/dofs/dof_handler.h>

#include <map>
#include <memory>
#include <set>

#include "base/shared_rows.h"
#include "solver/held_unknowns.h"
#include "solver/system_matrix.h"
#include "solver/tangent_operator.h"

namespace ElastoPlastic
{
  /// A symmetric, positive definite approximation of the inverse of a tangent,
  /// some unknowns being held.
  class TangentPreconditioner
  {
  public:
    virtual ~TangentPreconditioner() = default;

    /// Takes the tangent that is stored now.
    virtual void
    prepare(const HeldUnknowns &held) = 0;

    /// Both vectors are zero at constrained and eliminated unknowns.
    virtual void
    vmult(VectorType &result, const VectorType &vector) const = 0;
  };



  /// An assembled tangent, with hanging nodes condensed and constrained
  /// unknowns eliminated (their rows and columns are diagonal).
  template <int dim>
  class TangentMatrix
  {
  public:
    /// Sets up the sparsity pattern; both arguments must outlive this object
    /// or the next call.
    void
    reinit(const DoFHandler<dim>           &dof_handler,
           const AffineConstraints<double> &constraints);

    /// Assembles the tangent that @p tangent has stored: a TangentOperator or
    /// what else has add_matrix().
    template <typename Operator>
    void
    assemble(const Operator &tangent, const HeldUnknowns &held)
    {
      const Moves moves = moves_of(held.shared);
      make_room_for(moves);
      system_matrix = 0;
      tangent.add_matrix(system_matrix, with_held(held, moves));
      add_springs(held, moves);
    }

    const SystemMatrix &
    matrix() const
    {
      return system_matrix;
    }

    /// How many patterns the matrix has had.
    unsigned int
    n_patterns() const
    {
      return pattern_count;
    }

  private:
    using Combination = std::map<types::global_dof_index, double>;
    /// sum_b t_ib w_b for the unknowns i that have a row in SharedForces, as
    /// combinations of displacements of entering unknowns.
    using Moves = std::map<types::global_dof_index, Combination>;

    /// Those of all ranks. Collective.
    Moves
    moves_of(const SharedForces &shared) const;

    /// Makes a new sparsity pattern if the present one lacks their entries.
    /// Those that it has stay: the edge of a contact comes and goes.
    void
    make_room_for(const Moves &moves);

    void
    set_up_pattern();

    /// The entries that cells have once their unknowns move with others.
    void
    add_to_pattern_of_moves(SystemPattern &pattern) const;

    void
    add_springs(const HeldUnknowns &held, const Moves &moves);

    /// The constraints and, as homogeneous ones, those of the held unknowns.
    AffineConstraints<double>
    with_held(const HeldUnknowns &held, const Moves &moves) const;

    const DoFHandler<dim>           *dof_handler = nullptr;
    const AffineConstraints<double> *constraints = nullptr;
    IndexSet                         relevant_dofs;
    SystemMatrix                     system_matrix;
    unsigned int                     pattern_count = 0;
    /// By unknowns, those that they have moved with, on all ranks.
    std::map<types::global_dof_index, std::set<types::global_dof_index>>
      partners;
  };



  /// Assembles the tangent for a MatrixPreconditioner.
  template <int dim>
  class AssembledPreconditioner : public TangentPreconditioner
  {
  public:
    /// The references must outlive this object.
    AssembledPreconditioner(
      const TangentOperator                &tangent,
      std::unique_ptr<MatrixPreconditioner> preconditioner,
      const DoFHandler<dim>                &dof_handler,
      const AffineConstraints<double>      &constraints)
      : tangent(tangent)
      , preconditioner(std::move(preconditioner))
    {
      matrix.reinit(dof_handler, constraints);
    }

    void
    prepare(const HeldUnknowns &held) override
    {
      matrix.assemble(tangent, held);
      preconditioner->initialize(matrix.matrix(), matrix.n_patterns());
    }

    void
    vmult(VectorType &result, const VectorType &vector) const override
    {
      preconditioner->vmult(result, vector);
    }

  private:
    const TangentOperator                      &tangent;
    TangentMatrix<dim>                          matrix;
    const std::unique_ptr<MatrixPreconditioner> preconditioner;
  };
} // namespace ElastoPlastic

#endif
