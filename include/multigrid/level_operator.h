// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef multigrid_level_operator_h
#define multigrid_level_operator_h

#include <deal.II/base/subscriptor.h>

#include <memory>

#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// All vectors of the preconditioner have single precision.
  using LevelVector = LinearAlgebra::distributed::Vector<float>;



  /// The tangent operator on one level of multigrid. It differs from
  /// SolidOperator in what a preconditioner may leave out: single precision,
  /// and a tangent that is constant on each cell. Held unknowns are cut off:
  /// their rows and columns are those of the identity.
  template <int dim>
  class LevelOperator : public Subscriptor
  {
  public:
    using value_type = float;

    virtual ~LevelOperator() = default;

    /// Prepares everything that depends on the mesh. The arguments must outlive
    /// this object or the next call.
    virtual void
    reinit(const DoFHandler<dim>           &dof_handler,
           const AffineConstraints<double> &constraints) = 0;

    virtual void
    initialize_vector(LevelVector &vector) const = 0;

    /// Takes one of the numbers that describe the cells' tangents: entry
    /// @p index of CellTangent::values(), for all OwnedCells.
    virtual void
    set_tangent_value(const unsigned int index, const LevelVector &values) = 0;

    /// Cuts off the unknowns at which @p held is 1 (and not those where it
    /// is 0).
    virtual void
    set_held(const LevelVector &held) = 0;

    virtual void
    vmult(LevelVector &result, const LevelVector &vector) const = 0;

    /// The same: the operator is symmetric.
    void
    Tvmult(LevelVector &result, const LevelVector &vector) const
    {
      vmult(result, vector);
    }

    /// PreconditionChebyshev reads the diagonal in this way, entry by entry, if
    /// it has not been handed its inverse.
    types::global_dof_index
    m() const
    {
      LevelVector vector;
      initialize_vector(vector);
      return vector.size();
    }

    /// A locally owned entry of the diagonal.
    float
    el(const types::global_dof_index                  row,
       [[maybe_unused]] const types::global_dof_index column) const
    {
      AssertDimension(row, column);
      LevelVector inverse;
      inverse_diagonal(inverse);
      return 1.f / inverse(row);
    }

    /// The reciprocal of the diagonal; for the masters of constrained unknowns,
    /// it is an approximation.
    virtual void
    inverse_diagonal(LevelVector &values) const = 0;

    /// Sets the entries of the unknowns that are cut off to zero.
    virtual void
    zero_held(LevelVector &vector) const = 0;

    /// Adds the tangent to @p matrix, condensed with @p all_constraints, as
    /// SolidOperator does.
    virtual void
    add_matrix(TrilinosWrappers::SparseMatrix  &matrix,
               const AffineConstraints<double> &all_constraints) const = 0;
  };



  /// The level operator for FE_Q(@p degree)^dim.
  template <int dim>
  std::unique_ptr<LevelOperator<dim>>
  make_level_operator(const unsigned int degree,
                      const StrainModel &strain_model);
} // namespace ElastoPlastic

#endif
