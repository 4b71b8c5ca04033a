// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The reference of all parameters: what patterns are called, the order of
// entries and sections, and what would be misread as Markdown.

#include <deal.II/base/mpi.h>

#include <iostream>

#include "input/parameter_input.h"

using namespace dealii;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const std::string &description :
       {Patterns::Anything().description(),
        Patterns::Bool().description(),
        Patterns::Integer().description(),
        Patterns::Integer(1).description(),
        Patterns::Integer(2, 3).description(),
        Patterns::Double().description(),
        Patterns::Double(0, 1).description(),
        Patterns::Double(Patterns::Double::min_double_value, 0.5).description(),
        Patterns::Selection("box|half ball|file").description(),
        Patterns::List(Patterns::Double()).description(),
        Patterns::List(Patterns::Selection("a|b"), 1, 2).description()})
    std::cout << ElastoPlastic::allowed_values(description) << '\n';

  ParameterHandler prm;
  prm.declare_entry("Dimension", "3", Patterns::Integer(2, 3), "2 or 3.");
  prm.enter_subsection("Output");
  prm.enter_subsection("Part's (name)");
  prm.declare_entry("Deep", "", Patterns::Anything(), "Files: *.vtu, *.csv.");
  prm.leave_subsection();
  prm.declare_entry("Fields",
                    "never",
                    Patterns::Selection("always|never"),
                    "A sentence whose line is broken in such a way that the "
                    "next line begins with 1. It is no list. [No link.]");
  prm.leave_subsection();
  std::cout << '\n';
  ElastoPlastic::print_parameter_reference(prm, std::cout);
}
