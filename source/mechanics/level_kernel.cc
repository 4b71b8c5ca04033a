// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "mechanics/make_kernel.h"
#include "mechanics/matrix_free_kernel.templates.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int degree, typename StrainMeasure>
    using LevelKernel = MatrixFreeKernel<
      degree,
      typename StrainMeasure::OfIncrements,
      CellKernel<StrainMeasure::dim, CellTangents<StrainMeasure::dim>>>;
  } // namespace



  template <int dim>
  std::unique_ptr<CellKernel<dim, CellTangents<dim>>>
  make_level_kernel(const unsigned int degree, const StrainModel &strain_model)
  {
    return make_kernel<CellKernel<dim, CellTangents<dim>>,
                       dim,
                       LevelKernel,
                       FiniteIncrement,
                       FiniteIncrement>(degree, strain_model);
  }



  template std::unique_ptr<CellKernel<2, CellTangents<2>>>
  make_level_kernel(const unsigned int, const StrainModel &);
  template std::unique_ptr<CellKernel<3, CellTangents<3>>>
  make_level_kernel(const unsigned int, const StrainModel &);
} // namespace ElastoPlastic
