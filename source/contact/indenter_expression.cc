// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "contact/indenter_expression.h"

namespace ElastoPlastic
{
  template <int dim>
  IndenterExpression<dim>::IndenterExpression(const std::string &path,
                                              const std::string &text)
    : expression(path, text)
  {}



  template <int dim>
  double
  IndenterExpression<dim>::profile(const Point<dim - 1> &x) const
  {
    Point<2> horizontal;
    for (unsigned int d = 0; d < dim - 1; ++d)
      horizontal[d] = x[d];
    return expression.value(horizontal);
  }



  template class IndenterExpression<2>;
  template class IndenterExpression<3>;
} // namespace ElastoPlastic
