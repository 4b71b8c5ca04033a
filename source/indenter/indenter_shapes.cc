// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "indenter/indenter_shapes.h"

namespace ElastoPlastic
{
  // The curvature of a function f(r) is f'' along e = x/r, and in a body of
  // revolution f'/r along the circle.
  template <int dim>
  IndenterSurface<dim>
  IndenterSymmetric<dim>::surface(const Point<dim - 1> &x) const
  {
    const Tensor<1, dim - 1> distance = across(x);
    const double             r        = distance.norm();
    const SectionPoint       point    = section.at(r);
    Tensor<1, dim - 1>       e;
    e[0]                      = 1.;
    double               hoop = point.curvature;
    IndenterSurface<dim> result{point.height, {}, {}};
    if (r > 0.)
      {
        e            = distance / r;
        hoop         = point.slope / r;
        result.slope = point.slope * e;
      }
    if (symmetry == Symmetry::translation)
      hoop = 0.;
    const auto along = symmetrize(outer_product(e, e));
    result.curvature = point.curvature * along +
                       hoop * (unit_symmetric_tensor<dim - 1>() - along);
    return result;
  }



  template <int dim>
  IndenterSurface<dim>
  IndenterSymmetric<dim>::surface_for(const Point<dim - 1> &origin,
                                      const Point<dim - 1> &x,
                                      const double          body_size) const
  {
    const SectionPoint tip = section.at(0.);
    if (tip.slope > 0. &&
        across(origin).norm() <= this->rounding_of_coordinates * body_size)
      return {tip.height, {}, {}};
    return surface(x);
  }



  template <int dim>
  Tensor<1, dim - 1>
  IndenterSymmetric<dim>::across(const Point<dim - 1> &x) const
  {
    Tensor<1, dim - 1> result = x;
    if (dim == 3 && symmetry == Symmetry::translation)
      result[dim - 2] = 0.;
    return result;
  }



  template <int dim>
  std::optional<std::array<double, dim - 1>>
  IndenterSymmetric<dim>::half_widths() const
  {
    if (!is_strip())
      return {};
    std::array<double, dim - 1> result;
    result.fill(std::numeric_limits<double>::infinity());
    result[0] = section.edge;
    return result;
  }



  template <int dim>
  double
  IndenterSymmetric<dim>::section_area(const double height) const
  {
    if (dim == 3 && symmetry == Symmetry::translation)
      return 0.;
    const double radius = section.radius(height);
    return numbers::PI * radius * radius;
  }



  template class IndenterSymmetric<2>;
  template class IndenterSymmetric<3>;



  template <int dim>
  IndenterRectangularPunch<dim>::IndenterRectangularPunch(
    const std::vector<double> &half_widths)
  {
    AssertDimension(half_widths.size(), dim - 1);
    std::copy_n(half_widths.begin(), dim - 1, widths.begin());
  }



  template <int dim>
  double
  IndenterRectangularPunch<dim>::profile(const Point<dim - 1> &x) const
  {
    for (unsigned int d = 0; d < dim - 1; ++d)
      if (!within(std::abs(x[d]), widths[d]))
        return std::numeric_limits<double>::infinity();
    return 0;
  }



  template class IndenterRectangularPunch<2>;
  template class IndenterRectangularPunch<3>;



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
