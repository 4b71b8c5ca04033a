// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <limits>

#include "indenter/indenter_expression.h"

namespace ElastoPlastic
{
  template <int dim>
  IndenterExpression<dim>::IndenterExpression(const std::string &path,
                                              const std::string &text,
                                              const double       reach)
    : expression(path, text, ExpressionVariables::position)
    , reach(reach)
  {}



  template <int dim>
  double
  IndenterExpression<dim>::profile(const Point<dim - 1> &x) const
  {
    if (!within(x.norm(), reach))
      return std::numeric_limits<double>::infinity();
    Point<2> horizontal;
    for (unsigned int d = 0; d < dim - 1; ++d)
      horizontal[d] = x[d];
    return expression.value(horizontal);
  }



  template <int dim>
  IndenterSurface<dim>
  IndenterExpression<dim>::surface_for(const Point<dim - 1> & /*origin*/,
                                       const Point<dim - 1> &x,
                                       const double          body_size) const
  {
    return this->difference_quotients(x,
                                      std::min(1e-4 * reach, 1e-5 * body_size));
  }



  template class IndenterExpression<2>;
  template class IndenterExpression<3>;
} // namespace ElastoPlastic
