// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_decode_stl_h
#define indenter_decode_stl_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

#include "indenter/height_file.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A triangle of a surface by its corners, counterclockwise seen from
  /// outside.
  using Facet = std::array<Point<3>, 3>;

  /// The triangles of an STL file, of its text or its binary form, but for
  /// vertical ones, which no vertical line meets in a single point. The normals
  /// in the file are ignored. What is wrong in the file is an InputError.
  ///
  /// deal.II's readers do not fit: OpenCASCADE::read_STL() hands over what
  /// there is of a truncated file, GridIn::read_assimp() reads quadrilaterals
  /// only.
  std::vector<Facet>
  decode_stl(const HeightFile &file);
} // namespace ElastoPlastic

#endif
