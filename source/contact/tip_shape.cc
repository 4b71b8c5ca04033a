// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <cmath>
#include <set>

#include "contact/indenter_library.h"
#include "contact/tip_shape.h"

namespace ElastoPlastic
{
  namespace
  {
    double
    depth_factor(const std::string &type)
    {
      const std::set<std::string> cones   = {"cone", "wedge"};
      const std::set<std::string> punches = {"circular punch",
                                             "strip punch",
                                             "rectangular punch"};
      if (punches.count(type) > 0)
        return 1.;
      return cones.count(type) > 0 ? 2. - 4. / numbers::PI : 0.75;
    }



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



    /// int r^2/2 over all directions, by the trapezoidal rule.
    template <int dim>
    double
    section_area(const Indenter<dim> &indenter, const double height)
    {
      const unsigned int n_directions = (dim == 2 ? 1 : 720);
      double             sum          = 0;
      for (unsigned int i = 0; i < n_directions; ++i)
        {
          const double       angle = 2 * numbers::PI * i / n_directions;
          Tensor<1, dim - 1> direction;
          direction[0]       = std::cos(angle);
          direction[dim - 2] = (dim == 2 ? 1. : std::sin(angle));
          const double reach = reach_of_section(indenter, height, direction);
          if (std::isinf(reach))
            return 0.;
          sum += reach * reach;
        }
      return numbers::PI * sum / n_directions;
    }
  } // namespace



  template <int dim>
  TipShape
  make_tip_shape(const IndenterParameters &parameters)
  {
    const auto &type       = parameters.type;
    const bool  has_no_tip = (type == "image" || type == "height matrix");
    const std::shared_ptr<const Indenter<dim>> indenter =
      make_indenter<dim>(parameters);
    return {depth_factor(type), [=](const double height) {
              return has_no_tip ? 0. : section_area(*indenter, height);
            }};
  }



  template TipShape
  make_tip_shape<2>(const IndenterParameters &);
  template TipShape
  make_tip_shape<3>(const IndenterParameters &);
} // namespace ElastoPlastic
