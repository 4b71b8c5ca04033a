// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include "base/exceptions.h"
#include "base/text.h"
#include "loads/body_force.h"

namespace ElastoPlastic
{
  namespace
  {
    const std::string entry = "Body force";
  }



  void
  BodyForceParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      entry,
      components,
      "Force per volume that acts in the whole body, for instance its weight; "
      "with finite strains, per volume of the undeformed body. One expression "
      "in x, y (, z) and the time t for each dimension, separated by ';'. For "
      "instance: 0; -7.7e-5*t. Empty: none. Unit: force by volume.",
      Patterns::Anything());
  }



  template <int dim>
  BodyForce<dim>::BodyForce(const std::string &components)
  {
    if (components.empty())
      return;
    const auto texts = split(entry, components, ';');
    if (texts.size() != dim)
      throw InputError(entry,
                       components,
                       "it must have " + std::to_string(dim) +
                         " components separated by ';', one per dimension.");
    for (const std::string &text : texts)
      expressions.push_back(
        std::make_shared<const Expression<dim>>(entry, text));
  }



  template <int dim>
  bool
  BodyForce<dim>::is_present() const
  {
    return !expressions.empty();
  }



  template <int dim>
  Tensor<1, dim>
  BodyForce<dim>::value(const Point<dim> &point, const double time) const
  {
    Tensor<1, dim> result;
    for (unsigned int d = 0; d < expressions.size(); ++d)
      result[d] = expressions[d]->value(point, time);
    return result;
  }



  template class BodyForce<2>;
  template class BodyForce<3>;
} // namespace ElastoPlastic
