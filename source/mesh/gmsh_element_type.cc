// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <map>

#include "mesh/gmsh_element_type.h"

namespace ElastoPlastic
{
  namespace
  {
    /// Those that are often met and not read.
    std::string
    name_of_refused_type(const unsigned int number)
    {
      static const std::map<unsigned int, std::string> names = {
        {2, "triangles"},
        {9, "triangles"},
        {4, "tetrahedra"},
        {11, "tetrahedra"},
        {6, "prisms"},
        {13, "prisms"},
        {18, "prisms"},
        {7, "pyramids"},
        {14, "pyramids"},
        {19, "pyramids"}};
      const auto name = names.find(number);
      return name == names.end() ?
               "elements of Gmsh's type " + std::to_string(number) :
               name->second;
    }
  } // namespace



  const GmshElementType &
  gmsh_element_type(const unsigned int number, const GmshScanner &scanner)
  {
    static const std::map<unsigned int, GmshElementType> types = {
      {1, {1, 2, 2}},
      {3, {3, 4, 4}},
      {5, {5, 8, 8}},
      {8, {1, 2, 3}},
      {10, {3, 4, 9}},
      {12, {5, 8, 27}},
      {15, {15, 1, 1}},
      {16, {3, 4, 8}},
      {17, {5, 8, 20}}};
    const auto type = types.find(number);
    if (type == types.end())
      scanner.fail(
        "there are " + name_of_refused_type(number) +
        ", but only quadrilaterals (2D) and hexahedra (3D) of first or second "
        "order are read. In Gmsh, recombine or use transfinite surfaces and "
        "volumes, and set the element order to 1.");
    return type->second;
  }
} // namespace ElastoPlastic
