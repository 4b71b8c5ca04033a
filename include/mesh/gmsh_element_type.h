// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_gmsh_element_type_h
#define mesh_gmsh_element_type_h

#include "mesh/gmsh_scanner.h"

namespace ElastoPlastic
{
  /// A type of elements in a mesh file of Gmsh. The corners are the first
  /// nodes.
  struct GmshElementType
  {
    unsigned int number_of_first_order; ///< of the type with the same corners
    unsigned int n_corners;
    unsigned int n_nodes;
  };



  /// The type with Gmsh's @p number, which @p scanner has just read: points,
  /// lines, quadrilaterals and hexahedra of first and second order.
  /// @throws InputError for others.
  const GmshElementType &
  gmsh_element_type(const unsigned int number, const GmshScanner &scanner);
} // namespace ElastoPlastic

#endif
