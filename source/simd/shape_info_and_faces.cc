// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What is the same for all dimensions or numbers, and so is compiled once. (In
// deal.II 9.4, the headers of cell and face evaluation share an include guard
// and cannot meet in one file.)

#define FE_EVAL_FACTORY_DEGREE_MAX 1

#include "base/simd.h"

// first the batches, then what is made of them
#include <deal.II/matrix_free/evaluation_template_face_factory.templates.h>
#include <deal.II/matrix_free/shape_info.templates.h>

DEAL_II_NAMESPACE_OPEN

namespace internal
{
  template void
  FEFaceEvaluationFactory<2, ElastoPlastic::Simd<double>>::evaluate(
    const unsigned int,
    const EvaluationFlags::EvaluationFlags,
    const ElastoPlastic::Simd<double> *,
    FEEvaluationData<2, ElastoPlastic::Simd<double>, true> &);
  template void
  FEFaceEvaluationFactory<3, ElastoPlastic::Simd<double>>::evaluate(
    const unsigned int,
    const EvaluationFlags::EvaluationFlags,
    const ElastoPlastic::Simd<double> *,
    FEEvaluationData<3, ElastoPlastic::Simd<double>, true> &);

  namespace MatrixFreeFunctions
  {
    template struct ShapeInfo<ElastoPlastic::Simd<float>>;
    template struct ShapeInfo<ElastoPlastic::Simd<double>>;
  } // namespace MatrixFreeFunctions
} // namespace internal

DEAL_II_NAMESPACE_CLOSE
