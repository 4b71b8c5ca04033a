// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_stretched_field_h
#define mechanics_stretched_field_h

#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include "solver/tangent_operator.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// @p field stretched about @p centre by this @p factor: at the node x, its
  /// value at centre + (x - centre) / factor; where that is outside of the
  /// body, a value nearby. A field of elements FE_Q^dim that satisfies
  /// @p constraints; so does the result. Exact where cells are parallelepipeds,
  /// otherwise up to a part of a cell. A node looks through the cells between
  /// itself and that place, from rank to rank.
  /// Collective.
  template <int dim>
  VectorType
  stretched_field(const VectorType                &field,
                  const double                     factor,
                  const Point<dim>                &centre,
                  const DoFHandler<dim>           &dof_handler,
                  const AffineConstraints<double> &constraints);
} // namespace ElastoPlastic

#endif
