// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_boundary_condition_parameters_h
#define mesh_boundary_condition_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// The entries of the section "Boundary conditions". Each boundary of the
  /// geometry must appear in exactly one of them, see BoundaryConditions.
  struct BoundaryConditionParameters
  {
    std::vector<std::string> fixed;
    std::vector<std::string> roller;
    std::vector<std::string> free;
    std::vector<std::string> contact;
    std::string              prescribed_displacement;
    std::string              traction;

    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace ElastoPlastic

#endif
