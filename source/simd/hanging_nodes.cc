// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The interpolation on cells with hanging nodes, which every product needs.

#define FE_EVAL_FACTORY_DEGREE_MAX 2

#include "base/simd.h"

// first the batches, then what is made of them
#include <deal.II/matrix_free/evaluation_template_factory_hanging_nodes.templates.h>

#define INSTANTIATE(dim, Number)                   \
  template struct FEEvaluationHangingNodesFactory< \
    dim,                                           \
    Number,                                        \
    ElastoPlastic::Simd<Number>>;

DEAL_II_NAMESPACE_OPEN

namespace internal
{
  INSTANTIATE(2, float)
  INSTANTIATE(3, float)
  INSTANTIATE(2, double)
  INSTANTIATE(3, double)
} // namespace internal

DEAL_II_NAMESPACE_CLOSE
