// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef multigrid_level_operator_h
#define multigrid_level_operator_h

#include <array>
#include <memory>
#include <vector>

#include "base/compatibility.h"
#include "base/shared_rows.h"
#include "mechanics/cell_kernel.h"
#include "solver/held_unknowns.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// All vectors of the preconditioner have single precision.
  using LevelVector = LinearAlgebra::distributed::Vector<float>;



  /// The tangent on one level of multigrid: the kernel of SolidOperator with
  /// what a preconditioner may leave out, in single precision and with a
  /// tangent that is constant on each cell. Held unknowns are cut off: like
  /// those of eliminated ones, their rows and columns are those of the
  /// identity.
  template <int dim>
  class LevelOperator : public Observable
  {
  public:
    using value_type = float;

    /// For the elements of @p dof_handler, which like @p constraints must
    /// outlive this object. Collective.
    LevelOperator(const StrainModel               &strain_model,
                  const DoFHandler<dim>           &dof_handler,
                  const AffineConstraints<double> &constraints);

    void
    initialize_vector(LevelVector &vector) const
    {
      kernel->initialize_vector(vector);
    }

    /// Takes one of the numbers that describe the cells' tangents: entry
    /// @p index of CellTangents::value(), for all OwnedCells.
    void
    set_tangent_value(const unsigned int index, const LevelVector &values);

    /// To be called when all of these numbers have been set.
    void
    finish_tangents()
    {
      kernel->prepare_products(tangents);
    }

    /// Holds the unknowns at which @p constrained is 1 (and not those where it
    /// is 0), with the @p slopes, see HeldUnknowns.
    void
    set_held(const LevelVector &constrained, const LevelVector &slopes);

    /// Adds the stiffnesses @p springs to the diagonal.
    void
    set_springs(const LevelVector &springs);

    /// Lets held unknowns move against the entering ones that share their
    /// forces. Not for levels that corrections are taken from.
    void
    set_shared(const SharedForces &shared_forces);

    /// Whether this rank owns held unknowns on slopes.
    bool
    has_slopes() const
    {
      return !held_slopes.empty();
    }

    /// Puts the held unknowns, which are zero in @p vector, to their places on
    /// the slopes; and the transpose, which adds their forces to those along
    /// the slopes.
    void
    expand(LevelVector &vector) const
    {
      held_slopes.expand(vector);
    }

    void
    contract(LevelVector &forces) const
    {
      held_slopes.contract(forces);
    }

    void
    vmult(LevelVector &result, const LevelVector &vector) const;

    /// The same: the operator is symmetric.
    void
    Tvmult(LevelVector &result, const LevelVector &vector) const
    {
      vmult(result, vector);
    }

    /// The number of unknowns, and a locally owned entry of the diagonal:
    /// PreconditionChebyshev asks for them if it has not been handed the
    /// inverse of the diagonal.
    types::global_dof_index
    m() const;

    float
    el(const types::global_dof_index row,
       const types::global_dof_index column) const;

    /// The reciprocal of the diagonal, see CellKernel.
    void
    inverse_diagonal(LevelVector &values) const;

    /// Copies the entries of the unknowns that have springs.
    void
    copy_at_springs(LevelVector &to, const LevelVector &from) const;

    /// Sets the entries of the unknowns that are cut off to zero.
    void
    zero_constrained(LevelVector &vector) const;

    /// Adds the tangent to @p matrix, condensed with @p all_constraints, as
    /// SolidOperator does.
    void
    add_matrix(SystemMatrix                    &matrix,
               const AffineConstraints<double> &all_constraints) const
    {
      kernel->add_matrix(matrix, all_constraints, tangents);
    }

  private:
    /// Moves held unknowns, which are at zero, against entering ones; and the
    /// transpose. (What these share among themselves is left out: see
    /// ReducedUnknowns::release_entering().)
    void
    move_held(LevelVector &vector) const;

    void
    share_forces(LevelVector &forces) const;

    /// What both springs and shares add.
    void
    add_edge_to_diagonal(LevelVector &values) const;

    using Number = typename CellTangents<dim>::Number;
    using Kernel = CellKernel<dim, CellTangents<dim>>;

    const std::unique_ptr<Kernel> kernel;

    /// The cell batches' tangents, and where set_tangent_value() finds the
    /// values of each lane.
    CellTangents<dim>                                     tangents;
    std::vector<std::array<unsigned int, Number::size()>> cells;

    /// Those of held unknowns.
    Slopes<float> held_slopes;

    struct Spring
    {
      unsigned int index;
      float        stiffness;
    };
    std::vector<Spring> springs;

    SharedForces               shared;
    mutable std::vector<float> entering_values;

    /// Local indices of constrained unknowns, and of those and the eliminated
    /// ones.
    std::vector<unsigned int>  constrained_indices;
    std::vector<unsigned int>  cut_off_indices;
    mutable std::vector<float> cut_off_values;
  };
} // namespace ElastoPlastic

#endif
