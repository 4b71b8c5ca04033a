// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "mechanics/make_kernel.h"
#include "mechanics/matrix_free_solid_kernel.h"

namespace ElastoPlastic
{
  template <>
  std::unique_ptr<SolidKernel<3>>
  make_solid_kernel(const unsigned int degree, const StrainModel &strain_model)
  {
    return make_kernel<SolidKernel<3>,
                       3,
                       MatrixFreeSolidKernel,
                       FiniteStrain,
                       GeneralSmallStrain>(degree, strain_model);
  }
} // namespace ElastoPlastic
