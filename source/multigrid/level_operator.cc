// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "multigrid/matrix_free_level.h"

namespace ElastoPlastic
{
  template <int dim>
  std::unique_ptr<LevelOperator<dim>>
  make_level_operator(const unsigned int degree,
                      const StrainModel &strain_model)
  {
    if (degree == 1)
      return std::make_unique<MatrixFreeLevel<dim, 1>>(strain_model);
    AssertDimension(degree, 2);
    return std::make_unique<MatrixFreeLevel<dim, 2>>(strain_model);
  }



  template std::unique_ptr<LevelOperator<2>>
  make_level_operator(const unsigned int, const StrainModel &);
  template std::unique_ptr<LevelOperator<3>>
  make_level_operator(const unsigned int, const StrainModel &);
} // namespace ElastoPlastic
