// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include "base/exceptions.h"
#include "contact/contact_geometry.h"

namespace ElastoPlastic
{
  template <int dim>
  ContactBounds<dim>::ContactBounds(
    const std::function<IndenterSurface<dim>(const Point<dim> &)> &gap,
    const ContactGeometry                                          geometry)
    : gap(gap)
    , geometry(geometry)
  {
    Assert(geometry != ContactGeometry::automatic, ExcInternalError());
  }



  template <int dim>
  Tensor<1, dim - 1>
  ContactBounds<dim>::horizontal_displacement(const ContactNode<dim> &node,
                                              const Vector           &u)
  {
    Tensor<1, dim - 1> displacement;
    for (unsigned int d = 0; d < dim - 1; ++d)
      displacement[d] = u.local_element(node.horizontal[d]);
    return displacement;
  }



  template <int dim>
  IndenterSurface<dim>
  ContactBounds<dim>::gap_at_present_place(const ContactNode<dim> &node,
                                           const Vector           &u) const
  {
    Point<dim> place        = node.position;
    const auto displacement = horizontal_displacement(node, u);
    for (unsigned int d = 0; d < dim - 1; ++d)
      place[d] += displacement[d];
    try
      {
        const IndenterSurface<dim> surface = gap(place);
        if (std::isfinite(surface.height))
          return surface;
      }
    catch (const InputError &)
      {}
    return node.gap;
  }



  template <int dim>
  double
  ContactBounds<dim>::value(const ContactNode<dim> &node, const Vector &u) const
  {
    switch (geometry)
      {
        case ContactGeometry::normal:
          return node.gap.height +
                 node.gap.slope * horizontal_displacement(node, u);
        case ContactGeometry::present:
          return gap_at_present_place(node, u).height;
        default:
          return node.gap.height;
      }
  }



  template <int dim>
  SlopedBound
  ContactBounds<dim>::to_second_order(const ContactNode<dim> &node,
                                      const Vector           &u) const
  {
    SlopedBound bound;
    bound.index = node.index;
    if (geometry == ContactGeometry::vertical)
      return bound;
    const auto surface = geometry == ContactGeometry::present ?
                           gap_at_present_place(node, u) :
                           node.gap;
    bound.n_others     = dim - 1;
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        bound.others[d] = node.horizontal[d];
        bound.slope[d]  = surface.slope[d];
        if (geometry == ContactGeometry::present)
          for (unsigned int e = 0; e < dim - 1; ++e)
            bound.curvature[d][e] = surface.curvature[d][e];
      }
    return bound;
  }



  template <int dim>
  double
  ContactBounds<dim>::inclination(const ContactNode<dim> &node) const
  {
    return geometry == ContactGeometry::normal ?
             std::sqrt(1. + node.gap.slope.norm_square()) :
             1.;
  }



  template class ContactBounds<2>;
  template class ContactBounds<3>;
} // namespace ElastoPlastic
