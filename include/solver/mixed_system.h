// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_mixed_system_h
#define solver_mixed_system_h

#include <functional>

#include "solver/reduced_unknowns.h"
#include "solver/tangent_operator.h"

namespace ElastoPlastic
{
  /// The mixed form of a tangent (TangentOperator), with ReducedUnknowns, on
  /// vectors of reduced displacements and pressures:
  ///   [ A    s D^T ]
  ///   [ s D  -s^2  ],
  /// where the pressures are q / s. They belong to forces then, and if s is not
  /// less than the norm of D, the residual T u - f = r + D^T (D u - q), where r
  /// is the first row's, is at most sqrt(2) times that of the mixed form.
  class MixedSystem
  {
  public:
    /// Both arguments must outlive this object. s = 1.
    MixedSystem(const TangentOperator &tangent,
                const ReducedUnknowns &unknowns);

    /// Makes s an estimate of the norm of D, by power iteration from the
    /// reduced @p forces.
    void
    scale_pressures(const VectorType &forces);

    void
    initialize_vector(BlockVectorType &vector) const
    {
      tangent.initialize_mixed_vector(vector);
    }

    void
    vmult(BlockVectorType &result, const BlockVectorType &vector) const;

    /// The product with A alone.
    void
    vmult_moderate(VectorType &forces, const VectorType &increment) const;

    /// Solves approximately with the mixed form, as by elimination of the
    /// displacements: with @p solve_moderate for A, and with @p
    /// solve_pressures for what is left of the pressures.
    void
    precondition(
      BlockVectorType       &result,
      const BlockVectorType &vector,
      const std::function<void(VectorType &result, const VectorType &forces)>
                                   &solve_moderate,
      const PressurePreconditioner &solve_pressures) const;

  private:
    const TangentOperator &tangent;
    const ReducedUnknowns &unknowns;
    double                 pressure_unit = 1.;
    /// Of products.
    mutable BlockVectorType source, product;
  };
} // namespace ElastoPlastic

#endif
