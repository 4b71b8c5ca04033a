// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef solver_tangent_preconditioner_h
#define solver_tangent_preconditioner_h

#include "mechanics/solid_operator.h"

namespace ElastoPlastic
{
  /// A symmetric, positive definite approximation of the inverse of a body's
  /// stored tangent, some unknowns of the body being held.
  template <int dim>
  class TangentPreconditioner
  {
  public:
    virtual ~TangentPreconditioner() = default;

    /// Takes the stored tangent of @p solid. @p held has ones at the held
    /// unknowns that this rank owns, zeros elsewhere.
    virtual void
    prepare(const SolidOperator<dim> &solid, const VectorType &held) = 0;

    /// Both vectors are zero at held and constrained unknowns.
    virtual void
    vmult(VectorType &result, const VectorType &vector) const = 0;
  };
} // namespace ElastoPlastic

#endif
