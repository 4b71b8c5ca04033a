// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>

#include "base/exceptions.h"
#include "bounds/bound_checks.h"
#include "mesh/curved_boundaries.h"

namespace ElastoPlastic
{
  void
  check_materials_of_limit_load(const std::vector<Material<double>> &materials)
  {
    for (const Material<double> &material : materials)
      if (!std::isfinite(material.yield_radius) || !is_perfect(material))
        throw InputError(
          "Analysis",
          "limit load",
          "only a body of perfectly plastic materials has a limit load that "
          "this analysis can find. Set 'Material/Law = perfectly plastic' "
          "with a yield stress for each material, and 'Rate law = none'.");
  }



  template <int dim>
  void
  check_reach_of_indenter(const SplitBody<dim> &body)
  {
    if (std::none_of(body.conditions.begin(),
                     body.conditions.end(),
                     [](const auto &condition) {
                       return condition.is_reached;
                     }))
      throw InputError(
        "The indenter can never touch the body: no part of the contact "
        "boundary lies within its reach. Check 'Indenter/Position', its size "
        "and 'Indenter/Reach'.");
  }



  template <int dim>
  std::string
  warning_of_partial_reach(const SplitBody<dim> &body)
  {
    if (std::any_of(body.conditions.begin(),
                    body.conditions.end(),
                    [](const auto &condition) {
                      return condition.is_pressed();
                    }))
      return "";
    return "The indenter reaches parts of sides of the first mesh only. "
           "Stresses press where it reaches a whole side, and the lower bound "
           "is zero until there is one. Put the edges of the indenter on "
           "vertices of the mesh, or begin with smaller cells.";
  }



  std::string
  warning_of_constant_loads(const double lower_bound, const double upper_bound)
  {
    if (lower_bound >= 0.)
      return "";
    return std::string(upper_bound < 0. ?
                         "The load factor is negative: the body" :
                         "The load factor may be negative: perhaps the body") +
           " does not bear the tractions and body forces that are constant, "
           "unless the others act against the direction in which they are "
           "given. Look at the signs, or prescribe smaller constant loads.";
  }



  template <int dim>
  std::string
  warning_of_curved_body(const Triangulation<dim> &triangulation)
  {
    if (!has_curved_boundary(triangulation))
      return "";
    return "The boundary of the body is curved. Its bounds are those of the " +
           std::string(dim == 2 ? "polygon" : "polyhedron") +
           " that each mesh makes of it, which lacks what is beyond its sides, "
           "and fills a part of every hole. They may exclude what holds for "
           "the body, by about as much as the bounds of two meshes differ.";
  }



  template void
  check_reach_of_indenter(const SplitBody<2> &);
  template void
  check_reach_of_indenter(const SplitBody<3> &);
  template std::string
  warning_of_partial_reach(const SplitBody<2> &);
  template std::string
  warning_of_partial_reach(const SplitBody<3> &);
  template std::string
  warning_of_curved_body(const Triangulation<2> &);
  template std::string
  warning_of_curved_body(const Triangulation<3> &);
} // namespace ElastoPlastic
