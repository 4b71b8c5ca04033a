// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "base/exceptions.h"
#include "contact/contact_geometry.h"

namespace ElastoPlastic
{
  template <int dim>
  IndenterSurface<dim>
  ContactBounds<dim>::gap_at_present_place(const ContactNode<dim> &node,
                                           const Vector           &u) const
  {
    Point<dim> place        = node.position;
    const auto displacement = horizontal_part<dim>(node, u);
    for (unsigned int d = 0; d < dim - 1; ++d)
      place[d] += displacement[d];
    try
      {
        const IndenterSurface<dim> surface = gap(node.position, place);
        if (std::isfinite(surface.height))
          return surface;
      }
    catch (const InputError &)
      {}
    return node.gap;
  }



  template <int dim>
  IndenterSurface<dim>
  ContactBounds<dim>::surface(const ContactNode<dim> &node,
                              const Vector           &u) const
  {
    switch (geometry)
      {
        case ContactGeometry::normal:
          return {node.gap.height +
                    node.gap.slope * horizontal_part<dim>(node, u),
                  node.gap.slope,
                  {}};
        case ContactGeometry::present:
          return gap_at_present_place(node, u);
        default:
          return {node.gap.height, {}, {}};
      }
  }



  template <int dim>
  bool
  ContactBounds<dim>::reach(const ContactNode<dim> &node) const
  {
    constexpr double slope_of_wall = 1e3;
    return std::isfinite(node.gap.height) &&
           (!are_sloped() || node.gap.slope.norm() < slope_of_wall);
  }



  template class ContactBounds<2>;
  template class ContactBounds<3>;
} // namespace ElastoPlastic
