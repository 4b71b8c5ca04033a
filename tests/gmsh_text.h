// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_gmsh_text_h
#define tests_gmsh_text_h

#include <fstream>
#include <iostream>

#include "mesh/gmsh_file.h"
#include "refusal.h"

namespace ElastoPlastic
{
  /// The mesh that a file of Gmsh with this @p text describes. Warnings are
  /// printed.
  template <int dim>
  BoundaryNames
  make_mesh_from_text(const std::string  &text,
                      Triangulation<dim> &mesh,
                      GmshFileParameters  parameters = {})
  {
    parameters.file = "mesh.msh";
    std::ofstream(parameters.file) << text;
    parameters.check(dim);
    return make_mesh_from_gmsh_file(
      parameters,
      [](const std::string &warning) { std::cout << warning << std::endl; },
      mesh);
  }



  /// What is said about this @p text.
  template <int dim>
  void
  print_error(const std::string        &text,
              const GmshFileParameters &parameters = {})
  {
    const auto make = [&]() {
      Triangulation<dim> mesh(Triangulation<dim>::none, true);
      make_mesh_from_text(text, mesh, parameters);
    };
    std::cout << refusal(make) << '\n' << std::endl;
  }



  /// @p text with the first @p part of it replaced.
  inline std::string
  change(std::string        text,
         const std::string &part,
         const std::string &replacement)
  {
    return text.replace(text.find(part), part.size(), replacement);
  }
} // namespace ElastoPlastic

#endif
