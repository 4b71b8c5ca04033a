// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

/// Compiles deal.II's MatrixFree for the batches of base/simd.h: what deal.II's
/// own source/matrix_free/ does for its batches.

#ifndef simd_instantiate_matrix_free_h
#define simd_instantiate_matrix_free_h

/// deal.II's kernels for run-time degrees: MappingQ1 needs 1.
#define FE_EVAL_FACTORY_DEGREE_MAX 1

#include "base/simd.h"

// first the batches, then what is made of them
#include <deal.II/matrix_free/evaluation_template_factory.templates.h>
#include <deal.II/matrix_free/mapping_info.templates.h>
#include <deal.II/matrix_free/matrix_free.templates.h>
#include <deal.II/matrix_free/shape_info.templates.h>

#define INSTANTIATE_MATRIX_FREE(dim, Number)                                 \
  DEAL_II_NAMESPACE_OPEN                                                     \
  template class MatrixFree<dim, Number, ElastoPlastic::Simd<Number>>;       \
  template void                                                              \
  MatrixFree<dim, Number, ElastoPlastic::Simd<Number>>::internal_reinit(     \
    const std::shared_ptr<hp::MappingCollection<dim>> &,                     \
    const std::vector<const DoFHandler<dim> *> &,                            \
    const std::vector<const AffineConstraints<double> *> &,                  \
    const std::vector<IndexSet> &,                                           \
    const std::vector<hp::QCollection<dim>> &,                               \
    const AdditionalData &);                                                 \
  namespace internal                                                         \
  {                                                                          \
    namespace MatrixFreeFunctions                                            \
    {                                                                        \
      template struct MappingInfo<dim, Number, ElastoPlastic::Simd<Number>>; \
      template struct MappingInfoStorage<dim,                                \
                                         dim,                                \
                                         ElastoPlastic::Simd<Number>>;       \
      template struct MappingInfoStorage<dim - 1,                            \
                                         dim,                                \
                                         ElastoPlastic::Simd<Number>>;       \
    }                                                                        \
  }                                                                          \
  DEAL_II_NAMESPACE_CLOSE

/// The mapping is evaluated in double precision for both, and never integrated.
#define INSTANTIATE_MAPPING_EVALUATION(dim)                          \
  DEAL_II_NAMESPACE_OPEN                                             \
  namespace internal                                                 \
  {                                                                  \
    template void                                                    \
    FEEvaluationFactory<dim, ElastoPlastic::Simd<double>>::evaluate( \
      const unsigned int,                                            \
      const EvaluationFlags::EvaluationFlags,                        \
      const ElastoPlastic::Simd<double> *,                           \
      FEEvaluationData<dim, ElastoPlastic::Simd<double>, false> &);  \
  }                                                                  \
  DEAL_II_NAMESPACE_CLOSE

#endif
