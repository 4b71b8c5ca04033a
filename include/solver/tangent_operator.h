// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_tangent_operator_h
#define solver_tangent_operator_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <memory>

#include "solver/system_matrix.h"

namespace ElastoPlastic
{
  using namespace dealii;

  using VectorType = LinearAlgebra::distributed::Vector<double>;

  using BlockVectorType = LinearAlgebra::distributed::BlockVector<double>;

  /// Solves approximately with the Schur complement 1 + D A^-1 D^T of the mixed
  /// form of a tangent, see TangentOperator.
  class PressurePreconditioner
  {
  public:
    virtual ~PressurePreconditioner() = default;

    /// Collective. Not quite linear: it may iterate.
    virtual void
    vmult(VectorType &result, const VectorType &pressures) const = 0;
  };



  /// A stored tangent, as the linear solvers want to see it: all unknowns are
  /// free, but for eliminated ones (hanging nodes, skew rollers).
  ///
  /// A nearly incompressible body has a mixed form (doc/theory, "Nearly
  /// incompressible bodies"). Its tangent is T = A + D^T D, where A has
  /// moderate bulk moduli, and D u are volumetric strains times the root of the
  /// rest and of the volume. With the pressures q = D u beside the
  /// displacements u, both in units of the root of an energy, the mixed form is
  ///   [ A  D^T ]
  ///   [ D  -1  ].
  class TangentOperator
  {
  public:
    virtual ~TangentOperator() = default;

    virtual bool
    is_symmetric() const = 0;

    virtual void
    initialize_vector(VectorType &vector) const = 0;

    /// The product with @p increment, which need not have ghost values;
    /// condensed. Collective.
    virtual void
    vmult(VectorType &forces, const VectorType &increment) const = 0;

    /// Whether the mixed form is to be solved: some material's bulk modulus is
    /// large against its shear modulus.
    virtual bool
    is_nearly_incompressible() const = 0;

    /// Makes a vector of the mixed form, displacements and pressures. Products
    /// need no ghost values.
    virtual void
    initialize_mixed_vector(BlockVectorType &vector) const = 0;

    /// The product with the mixed form; condensed. Collective.
    virtual void
    mixed_vmult(BlockVectorType       &result,
                const BlockVectorType &vector) const = 0;

    /// For the tangent that is stored now, with displacements held where @p
    /// held is not 0 (at their place: slopes are left out). The result must not
    /// outlive this operator. Collective.
    virtual std::unique_ptr<const PressurePreconditioner>
    make_pressure_preconditioner(const VectorType &held) const = 0;

    /// Adds the tangent to @p matrix, condensed with @p all_constraints, which
    /// contain at least its own. Collective.
    virtual void
    add_matrix(SystemMatrix                    &matrix,
               const AffineConstraints<double> &all_constraints) const = 0;
  };
} // namespace ElastoPlastic

#endif
