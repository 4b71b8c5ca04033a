// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/exceptions.h"
#include "mechanics/initial_stress.h"

namespace ElastoPlastic
{
  namespace
  {
    const std::string initial_stress_section = "Initial stress";

    const std::array<std::string, 6> component_names = {{"Stress xx",
                                                         "Stress yy",
                                                         "Stress zz",
                                                         "Stress xy",
                                                         "Stress xz",
                                                         "Stress yz"}};

    const std::array<std::string, 6> component_meanings = {
      {"The stress that the body bears before the load history begins, such as "
       "what grinding, peening or cooling has left: the component xx, in a body "
       "of revolution the radial one. An expression in x, y (, z). The shape of "
       "the mesh is that of the body under this stress; it is at rest there, "
       "and displacements and strains count from there. The stress must be in "
       "equilibrium with supports, tractions and body forces at t = 0. What "
       "little is missing, the program adds, and says how much: the elastic "
       "response to it; of more than a tenth, it says so and ends. Tension is "
       "positive. Empty: none. Unit: stress.",
       "The component yy, in a body of revolution the one along the axis.",
       "The component zz: in plane strain the one across the section, in a body "
       "of revolution the one around the axis. A sheet has none.",
       "The component xy, in a body of revolution the shear of the section.",
       "The component xz, of a body in space.",
       "The component yz, of a body in space."}};
  } // namespace



  void
  InitialStressParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection(initial_stress_section);
    for (unsigned int i = 0; i < component_names.size(); ++i)
      prm.add_parameter(component_names[i],
                        components[i],
                        component_meanings[i],
                        Patterns::Anything());
    prm.leave_subsection();
  }



  bool
  InitialStressParameters::is_present() const
  {
    return std::any_of(components.begin(),
                       components.end(),
                       [](const std::string &text) { return !text.empty(); });
  }



  template <int dim>
  InitialStress<dim>::InitialStress(const InitialStressParameters &parameters,
                                    const Kinematics               kinematics)
  {
    for (unsigned int i = 0; i < component_names.size(); ++i)
      if (const std::string &text = parameters.components[i]; !text.empty())
        {
          const std::string entry =
            initial_stress_section + "/" + component_names[i];
          if (dim == 2 && i >= 4)
            throw InputError(entry,
                             text,
                             "a body in two dimensions bears no shear across "
                             "its section. Leave it empty, or set 'Dimension = "
                             "3'.");
          if (i == 2 && kinematics == Kinematics::plane_stress)
            throw InputError(entry,
                             text,
                             "a sheet bears no stress across. Leave it empty, "
                             "or set 'Kinematics = plane strain'.");
          expressions[i] = std::make_shared<const Expression<dim>>(
            entry, text, ExpressionVariables::position);
        }
  }



  template <int dim>
  bool
  InitialStress<dim>::is_present() const
  {
    return std::any_of(expressions.begin(),
                       expressions.end(),
                       [](const auto &expression) {
                         return expression != nullptr;
                       });
  }



  template <int dim>
  SymmetricTensor<2, 3>
  InitialStress<dim>::value(const Point<dim> &point) const
  {
    SymmetricTensor<2, 3> result;
    for (unsigned int i = 0; i < expressions.size(); ++i)
      if (expressions[i])
        result.access_raw_entry(i) = expressions[i]->value(point);
    return result;
  }



  template class InitialStress<2>;
  template class InitialStress<3>;
} // namespace ElastoPlastic
