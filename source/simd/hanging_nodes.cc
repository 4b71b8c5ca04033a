// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The interpolation on cells with hanging nodes, which every product needs.

#define FE_EVAL_FACTORY_DEGREE_MAX 2

#include "base/simd.h"

// first the batches, then what is made of them
#include <deal.II/matrix_free/evaluation_template_factory_hanging_nodes.templates.h>

DEAL_II_NAMESPACE_OPEN

namespace internal
{
  template struct FEEvaluationHangingNodesFactory<2,
                                                  float,
                                                  ElastoPlastic::Simd<float>>;
  template struct FEEvaluationHangingNodesFactory<3,
                                                  float,
                                                  ElastoPlastic::Simd<float>>;
  template struct FEEvaluationHangingNodesFactory<2,
                                                  double,
                                                  ElastoPlastic::Simd<double>>;
  template struct FEEvaluationHangingNodesFactory<3,
                                                  double,
                                                  ElastoPlastic::Simd<double>>;
} // namespace internal

DEAL_II_NAMESPACE_CLOSE
