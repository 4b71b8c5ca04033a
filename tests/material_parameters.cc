// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The section "Material": from lists in a file to constants, and what is said
// about mistakes.

#include <deal.II/base/mpi.h>

#include <iomanip>

#include "material/material_parameters.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  MaterialParameters
  parameters_from(const std::string &text)
  {
    ParameterHandler   prm;
    MaterialParameters parameters;
    parameters.add_parameters(prm);
    prm.parse_input_from_string("subsection Material\n" + text + "\nend");
    parameters.check();
    return parameters;
  }



  void
  print_materials(const std::string &title, const std::string &text)
  {
    output() << title << std::endl;
    for (const auto &material : parameters_from(text).materials())
      output() << "  K = " << material.bulk_modulus
               << ", G = " << material.shear_modulus
               << ", radius = " << material.yield_radius
               << ", 2/3 H = " << material.isotropic_modulus
               << ", 2/3 H_k = " << material.kinematic_modulus << std::endl;
  }



  void
  print_mistake(const std::string &text)
  {
    print_error(text, [&] { parameters_from(text); });
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  output() << std::setprecision(10);

  print_materials("default", "");
  print_materials("every law takes the moduli it knows",
                  "set Law = linear elastic, perfectly plastic, isotropic "
                  "hardening, kinematic hardening, combined hardening\n"
                  "set Isotropic hardening modulus = 300\n"
                  "set Kinematic hardening modulus = 600");
  print_materials("lists",
                  "set Young's modulus = 3, 6\n"
                  "set Poisson's ratio = 0, 0.25\n"
                  "set Yield stress = 1, 2\n"
                  "set Isotropic hardening modulus = 0.3, 0.6");

  print_mistake("set Young's modulus = 0");
  print_mistake("set Young's modulus = 1, -1");
  print_mistake("set Poisson's ratio = 0.5");
  print_mistake("set Poisson's ratio = -1");
  print_mistake("set Yield stress = 0");
  print_mistake("set Isotropic hardening modulus = -1");
  print_mistake("set Kinematic hardening modulus = -1");
  print_mistake(
    "set Yield stress = 1, 2\n"
    "set Poisson's ratio = 0.1, 0.2, 0.3");
  print_mistake(
    "set Law = linear elastic, perfectly plastic\n"
    "set Yield stress = 1, 2, 3");
}
