// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef evaluation_profile_line_h
#define evaluation_profile_line_h

#include <deal.II/base/point.h>

#include <limits>
#include <string>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// A straight line on the contact surface of a body in space, seen from
  /// above: a point, a direction, and between which distances from the point.
  struct ProfileLine
  {
    Point<2>     point;
    Tensor<1, 2> direction; ///< of length 1
    double       begin = -std::numeric_limits<double>::infinity();
    double       end   = std::numeric_limits<double>::infinity();
  };



  /// The lines that the entry Output/Profile lines names, such as
  /// "0, 0; 1, 1 | 0, 0; 0, 2"; without any, that through @p axis along x.
  /// @throws InputError
  std::vector<ProfileLine>
  read_profile_lines(const std::string &text, const Point<2> &axis);
} // namespace ElastoPlastic

#endif
