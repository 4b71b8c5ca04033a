// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_gmsh_text_h
#define tests_gmsh_text_h

#include <fstream>
#include <iostream>

#include "mesh/gmsh_file.h"

namespace ElastoPlastic
{
  /// The mesh that a file of Gmsh with this @p text describes. Warnings are
  /// printed.
  template <int dim>
  BoundaryNames
  make_mesh_from_text(const std::string  &text,
                      Triangulation<dim> &mesh,
                      const Curves        curves = Curves::followed)
  {
    GmshFileParameters parameters;
    parameters.file   = "mesh.msh";
    parameters.curves = curves;
    std::ofstream(parameters.file) << text;
    parameters.check(dim);
    return make_mesh_from_gmsh_file(
      parameters,
      [](const std::string &warning) { std::cout << warning << std::endl; },
      mesh);
  }
} // namespace ElastoPlastic

#endif
