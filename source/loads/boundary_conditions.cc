// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

#include "base/exceptions.h"
#include "base/text.h"
#include "loads/boundary_conditions.h"

namespace ElastoPlastic
{
  void
  BoundaryConditionParameters::add_parameters(ParameterHandler &prm)
  {
    const std::string    example = ", for instance: bottom, left.";
    const Patterns::List names{Patterns::Anything()};
    const std::string    in_components =
      "Boundaries are separated by '|', the name from its components by ':', "
      "the components, one per dimension, by ';'. Each is an expression in x, "
      "y (, z) and the time t; conditions are written if(t < 1, t, 1), and '|' "
      "cannot be used in them";

    prm.enter_subsection("Boundary conditions");
    prm.add_parameter("Fixed",
                      fixed,
                      "Boundaries where the displacement is zero" + example,
                      names);
    prm.add_parameter(
      "Roller",
      roller,
      "Boundaries that slide along their own surface without friction (normal "
      "displacement and tangential traction are zero), like planes of "
      "symmetry" +
        example,
      names);
    prm.add_parameter("Free",
                      free,
                      "Boundaries without traction" + example,
                      names);
    prm.add_parameter(
      "Contact",
      contact,
      "Boundaries that the indenter can touch, without traction where it does "
      "not. They should be level, facing upwards, for instance: top.",
      names);
    prm.add_parameter(
      "Prescribed displacement",
      prescribed_displacement,
      "Boundaries with a given displacement. " + in_components +
        "; the word free leaves a component free. For instance: "
        "right: 0.01*t; free | left: 0; free. Unit: length.",
      Patterns::Anything());
    prm.add_parameter("Traction",
                      traction,
                      "Boundaries that carry a given traction. " +
                        in_components +
                        ". For instance: right: 100*t; 0. Unit: stress.",
                      Patterns::Anything());
    prm.leave_subsection();
  }



  namespace
  {
    using Type = BoundaryConditionType;

    const std::string section = "Boundary conditions/";



    /// Where the name ends in "name: component; component". The name of a
    /// boundary may contain colons: the longest one that there is counts.
    std::size_t
    end_of_name(const std::string &text, const BoundaryNames &names)
    {
      std::size_t end = text.find(':');
      for (std::size_t colon = end; colon != std::string::npos;
           colon             = text.find(':', colon + 1))
        if (names.count(Utilities::trim(text.substr(0, colon))) > 0)
          end = colon;
      return end;
    }



    /// Read "component; component" into @p components.
    template <int dim>
    void
    read_components(const std::string                            &path,
                    const Type                                    type,
                    const std::string                            &text,
                    typename BoundaryConditions<dim>::Components &components)
    {
      const auto texts = split(path, text, ';');
      if (texts.size() != dim)
        throw InputError(path,
                         text,
                         "it must have " + std::to_string(dim) +
                           " components separated by ';', one per dimension.");
      for (unsigned int d = 0; d < dim; ++d)
        if (texts[d] != "free")
          components[d] =
            std::make_shared<const Expression<dim>>(path, texts[d]);
        else if (type == Type::traction)
          throw InputError(path,
                           text,
                           "a component of a traction cannot be free. Where "
                           "there is none, it is 0.");
    }
  } // namespace



  template <int dim>
  BoundaryConditions<dim>::BoundaryConditions(
    const BoundaryConditionParameters &parameters, const BoundaryNames &names)
    : boundary_names(names)
  {
    const auto add_all = [&](const std::string              &entry,
                             const Type                      type,
                             const std::vector<std::string> &boundaries) {
      for (const std::string &name : boundaries)
        add_boundary(entry, type, name);
    };
    add_all("Fixed", Type::fixed, parameters.fixed);
    add_all("Roller", Type::roller, parameters.roller);
    add_all("Free", Type::free, parameters.free);
    add_all("Contact", Type::contact, parameters.contact);
    displacements =
      add_boundaries_with_components("Prescribed displacement",
                                     Type::prescribed_displacement,
                                     parameters.prescribed_displacement);
    traction_vectors = add_boundaries_with_components("Traction",
                                                      Type::traction,
                                                      parameters.traction);

    BoundaryNames without_condition;
    for (const auto &[name, id] : names)
      if (conditions.count(id) == 0)
        without_condition.emplace(name, id);
    if (!without_condition.empty())
      throw InputError(
        "Boundaries without a condition: " + list_of_names(without_condition) +
        ". Name each in one of the entries 'Fixed', 'Roller', "
        "'Free', 'Contact', 'Prescribed displacement' and "
        "'Traction' of the section 'Boundary conditions'.");
  }



  template <int dim>
  std::set<types::boundary_id>
  BoundaryConditions<dim>::ids(const BoundaryConditionType type) const
  {
    std::set<types::boundary_id> result;
    for (const auto &[id, condition] : conditions)
      if (condition.type == type)
        result.insert(id);
    return result;
  }



  template <int dim>
  double
  BoundaryConditions<dim>::largest_value(const types::boundary_id boundary,
                                         const Point<dim>        &point,
                                         const double             time) const
  {
    double largest = 0;
    for (const auto *const values : {&displacements, &traction_vectors})
      if (const auto found = values->find(boundary); found != values->end())
        for (const auto &component : found->second)
          if (component)
            largest =
              std::max(largest, std::abs(component->value(point, time)));
    return largest;
  }



  template <int dim>
  void
  BoundaryConditions<dim>::add_boundary(const std::string          &entry,
                                        const BoundaryConditionType type,
                                        const std::string          &name)
  {
    const auto boundary = boundary_names.find(name);
    if (boundary == boundary_names.end())
      throw InputError(section + entry,
                       name,
                       "there is no such boundary. The geometry has: " +
                         list_of_names(boundary_names) + ".");

    const auto [condition, is_first] =
      conditions.emplace(boundary->second, Condition{type, entry});
    if (!is_first)
      throw InputError("The boundary '" + name +
                       (condition->second.entry == entry ?
                          "' is named twice in '" + section + entry :
                          "' has two conditions: it is named in '" + section +
                            condition->second.entry + "' and in '" + section +
                            entry) +
                       "'. Name each boundary once.");
  }



  template <int dim>
  std::map<types::boundary_id, typename BoundaryConditions<dim>::Components>
  BoundaryConditions<dim>::add_boundaries_with_components(
    const std::string          &entry,
    const BoundaryConditionType type,
    const std::string          &text)
  {
    std::map<types::boundary_id, Components> result;
    for (const std::string &boundary : split(section + entry, text, '|'))
      {
        const std::size_t colon = end_of_name(boundary, boundary_names);
        if (colon == std::string::npos)
          throw InputError(section + entry,
                           boundary,
                           "it must look like 'name: component; component', "
                           "with one component per dimension, and '|' between "
                           "boundaries.");
        const std::string name = Utilities::trim(boundary.substr(0, colon));
        add_boundary(entry, type, name);
        read_components<dim>(section + entry,
                             type,
                             Utilities::trim(boundary.substr(colon + 1)),
                             result[boundary_names.at(name)]);
      }
    return result;
  }



  template class BoundaryConditions<2>;
  template class BoundaryConditions<3>;
} // namespace ElastoPlastic
