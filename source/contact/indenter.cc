// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <cmath>
#include <limits>

#include "contact/indenter.h"

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
  } // namespace



  template <int dim>
  bool
  Indenter<dim>::is_convex() const
  {
    return false;
  }



  template <int dim>
  double
  Indenter<dim>::detail() const
  {
    return 0.;
  }



  template <int dim>
  double
  Indenter<dim>::depth_factor() const
  {
    return 0.75;
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



  template class Indenter<2>;
  template class Indenter<3>;
} // namespace ElastoPlastic
