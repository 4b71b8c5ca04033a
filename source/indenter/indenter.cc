// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "indenter/indenter.h"

namespace ElastoPlastic
{
  namespace
  {
    /// How far a section reaches from the tip in a horizontal @p direction: the
    /// profile grows along it. Infinite if it is not bounded.
    template <int dim>
    double
    reach_of_section(const Indenter<dim>      &indenter,
                     const double              height,
                     const Tensor<1, dim - 1> &direction)
    {
      const auto is_inside = [&](const double distance) {
        return indenter.profile(Point<dim - 1>(distance * direction)) <= height;
      };
      const double unbounded = 1e12 * height;
      double       outside   = height;
      while (is_inside(outside))
        {
          outside *= 2;
          if (outside > unbounded)
            return std::numeric_limits<double>::infinity();
        }
      double             inside       = 0;
      const unsigned int n_bisections = 55; // to the last digit
      for (unsigned int i = 0; i < n_bisections; ++i)
        {
          const double middle                    = 0.5 * (inside + outside);
          (is_inside(middle) ? inside : outside) = middle;
        }
      return inside;
    }



    /// Where the three points for the derivatives at @p x along an axis have
    /// their middle: at x, or a step to the side where the profile is finite.
    template <int dim>
    double
    shift_of_stencil(const Indenter<dim>      &indenter,
                     const Point<dim - 1>     &x,
                     const Tensor<1, dim - 1> &step)
    {
      if (std::isinf(indenter.profile(x + step)))
        return -1.;
      if (std::isinf(indenter.profile(x - step)))
        return 1.;
      return 0.;
    }
  } // namespace



  template <int dim>
  IndenterSurface<dim>
  Indenter<dim>::difference_quotients(const Point<dim - 1> &x,
                                      const double          h) const
  {
    IndenterSurface<dim> result{profile(x), {}, {}};
    if (std::isinf(result.height))
      return result;

    std::array<Tensor<1, dim - 1>, dim - 1> step;
    Point<dim - 1>                          middle = x;
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        step[d][d]                 = h;
        const double         shift = shift_of_stencil(*this, x, step[d]);
        const Point<dim - 1> z     = x + shift * step[d];
        const double left = profile(z - step[d]), right = profile(z + step[d]);
        middle += shift * step[d];
        if (std::isinf(left) || std::isinf(right))
          continue;
        result.curvature[d][d] = (left - 2 * profile(z) + right) / (h * h);
        result.slope[d] =
          (right - left) / (2 * h) - shift * h * result.curvature[d][d];
      }

    if (dim == 3)
      {
        const Tensor<1, dim - 1> along  = step[0] + step[dim - 2],
                                 across = step[0] - step[dim - 2];
        const double twist =
          (profile(middle + along) - profile(middle + across) -
           profile(middle - across) + profile(middle - along)) /
          (4 * h * h);
        if (std::isfinite(twist))
          result.curvature[0][dim - 2] = twist;
      }
    return result;
  }



  template <int dim>
  IndenterSurface<dim>
  Indenter<dim>::surface_for(const Point<dim - 1> & /*origin*/,
                             const Point<dim - 1> &x,
                             const double /* body_size */) const
  {
    return surface(x);
  }



  // int r^2/2 over all directions, by the trapezoidal rule.
  template <int dim>
  double
  Indenter<dim>::section_area(const double height) const
  {
    const unsigned int n_directions = (dim == 2 ? 1 : 720);
    double             sum          = 0;
    for (unsigned int i = 0; i < n_directions; ++i)
      {
        const double       angle = 2 * numbers::PI * i / n_directions;
        Tensor<1, dim - 1> direction;
        direction[0]       = std::cos(angle);
        direction[dim - 2] = (dim == 2 ? 1. : std::sin(angle));
        const double reach = reach_of_section(*this, height, direction);
        if (std::isinf(reach))
          return 0.;
        sum += reach * reach;
      }
    return numbers::PI * sum / n_directions;
  }



  template <int dim>
  double
  PlacedIndenter<dim>::growth_of_contact(const double depth,
                                         const double next) const
  {
    constexpr double largest = 3.;

    const double tip = depth - initial_gap;
    if (!shape || !shape->is_convex() || !(tip > 0.) || !(next > depth))
      return 1.;
    const double area = shape->section_area(tip);
    return area > 0. ?
             std::min(largest,
                      std::sqrt(shape->section_area(tip + next - depth) /
                                area)) :
             1.;
  }



  template class Indenter<2>;
  template class Indenter<3>;
  template struct PlacedIndenter<2>;
  template struct PlacedIndenter<3>;
} // namespace ElastoPlastic
