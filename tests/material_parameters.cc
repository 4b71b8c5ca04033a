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
      {
        output() << "  K = " << material.bulk_modulus
                 << ", G = " << material.shear_modulus
                 << ", radius = " << material.yield_radius
                 << ", 2/3 H = " << material.isotropic_modulus;
        for (const auto &[modulus, recovery] : material.back_stresses)
          output() << ", 2/3 C = " << modulus
                   << ", sqrt(2/3) gamma = " << recovery;
        if (material.curves[0])
          output() << ", h(0.01), h(1) = " << material.curves[0]->value(0.01)
                   << ' ' << material.curves[0]->value(1.);
        output() << (has_limit(material) ? ", limited" : "") << std::endl;
      }
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

  const std::string nonlinear =
    "set Law = nonlinear hardening\n"
    "set Isotropic hardening modulus = 0\n";
  print_materials("nothing but the yield stress", nonlinear);
  print_materials("Voce and power law",
                  nonlinear +
                    "set Voce stress = 200, 0\n"
                    "set Voce rate = 10\n"
                    "set Power law exponent = 0, 0.5\n"
                    "set Power law reference strain = 1");
  print_materials("tables",
                  nonlinear +
                    "set Hardening table = none, 0: 400|0.02: 500|1: 600");
  print_materials("back stresses",
                  nonlinear +
                    "set Back stress moduli = 300 | 30, none, 0\n"
                    "set Recovery rates = 10 | 1, none, 1");
  print_materials("a back stress without recovery",
                  nonlinear +
                    "set Back stress moduli = 300 | 30\n"
                    "set Recovery rates = 10 | 0");

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
  print_mistake("set Voce stress = -1");
  print_mistake("set Voce rate = -1");
  print_mistake("set Voce stress = 1");
  print_mistake("set Power law exponent = 1.1");
  print_mistake("set Power law reference strain = 0");
  print_mistake("set Hardening table = 0.1 500");
  print_mistake("set Hardening table = 0: 410");
  print_mistake("set Hardening table = 0.1: 500 | 0.2: 499");
  print_mistake("set Hardening table = 0.1: 399");
  print_mistake("set Back stress moduli = x");
  print_mistake("set Back stress moduli = 1 | 2 | 3 | 4 | 5");
  print_mistake("set Back stress moduli = 1 | 2\nset Recovery rates = 1");
}
