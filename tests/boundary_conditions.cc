// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Boundary conditions from the texts of a parameter file, and what is said
// about each mistake in them.

#include <deal.II/base/mpi.h>

#include <iostream>

#include "loads/boundary_conditions.h"
#include "refusal.h"

using namespace ElastoPlastic;

namespace
{
  const BoundaryNames names = {{"left", 0},
                               {"right", 1},
                               {"bottom", 2},
                               {"top", 3}};



  BoundaryConditions<2>
  conditions_from(const std::string   &text,
                  const BoundaryNames &boundary_names = names)
  {
    ParameterHandler            prm;
    BoundaryConditionParameters parameters;
    parameters.add_parameters(prm);
    prm.parse_input_from_string("subsection Boundary conditions\n" + text +
                                "\nend");
    return BoundaryConditions<2>(parameters, boundary_names);
  }



  void
  print(const std::string &title,
        const std::map<types::boundary_id, BoundaryConditions<2>::Components>
          &boundaries)
  {
    std::cout << title << " at (2, 3), t = 0.5:";
    for (const auto &[id, components] : boundaries)
      for (unsigned int d = 0; d < 2; ++d)
        {
          std::cout << " [" << id << "]_" << d << " = ";
          if (components[d])
            std::cout << components[d]->value(Point<2>(2, 3), 0.5);
          else
            std::cout << "free";
        }
    std::cout << std::endl;
  }



  void
  print(const std::string                  &title,
        const std::set<types::boundary_id> &boundaries)
  {
    std::cout << title << ':';
    for (const types::boundary_id id : boundaries)
      std::cout << ' ' << id;
    std::cout << std::endl;
  }



  void
  print(const BoundaryConditions<2> &conditions)
  {
    using Type = BoundaryConditionType;
    print("fixed", conditions.ids(Type::fixed));
    print("roller", conditions.ids(Type::roller));
    print("free", conditions.ids(Type::free));
    print("contact", conditions.ids(Type::contact));
    print("displaced", conditions.ids(Type::prescribed_displacement));
    print("loaded", conditions.ids(Type::traction));
    print("displacements", conditions.prescribed_displacements());
    print("tractions", conditions.tractions());
    std::cout << std::endl;
  }



  void
  print_error(const std::string &text)
  {
    std::cout << refusal([&]() { conditions_from(text); }) << '\n' << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  print(
    conditions_from("set Fixed = bottom\n"
                    "set Free = left, right\n"
                    "set Contact = top"));
  print(conditions_from(
    "set Roller = left\n"
    "set Free = bottom\n"
    "set Prescribed displacement = "
    "top: free; -0.01*t*x | right: if(t < 1, min(x, y), 0); free\n"));
  print(
    conditions_from("set Fixed = left\n"
                    "set Roller = bottom\n"
                    "set Traction = right : 100*t; 0 | top: x; y"));

  // A name may contain colons.
  print(conditions_from("set Traction = lid : z: 1; 2 | lid: 3; 4",
                        {{"lid", 0}, {"lid : z", 1}}));

  // Names that do not fit the geometry.
  print_error("set Fixed = bottom, lower");
  print_error(
    "set Fixed = bottom\n"
    "set Contact = top");
  print_error(
    "set Fixed = bottom, left\n"
    "set Traction = right: 0; 0 | left: 1; 0");
  print_error("set Fixed = bottom, bottom");
  print_error("set Prescribed displacement = top: 0; 0 | top: 1; 1");

  // Components.
  print_error("set Prescribed displacement = top 0; 0");
  print_error("set Prescribed displacement = top: 0");
  print_error("set Prescribed displacement = top: 0; 0; 0");
  print_error("set Fixed = bottom\nset Traction = top: free; 0");
}
