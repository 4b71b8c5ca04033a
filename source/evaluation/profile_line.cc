// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/exceptions.h"
#include "base/text.h"
#include "evaluation/profile_line.h"

namespace ElastoPlastic
{
  namespace
  {
    const std::string lines_entry = "Output/Profile lines";



    /// @throws InputError
    Point<2>
    read_end_of_line(const std::string &text, const std::string &line)
    {
      const auto parts = split(lines_entry, text, ',');
      Point<2>   point;
      bool       is_point = parts.size() == 2;
      for (unsigned int d = 0; d < 2 && is_point; ++d)
        if (const auto value = as_number(parts[d]); value)
          point[d] = *value;
        else
          is_point = false;
      if (!is_point || !std::isfinite(point.norm()))
        throw InputError(lines_entry,
                         line,
                         "it must look like 'x, y; x, y', the horizontal "
                         "coordinates of both ends of a line, with '|' between "
                         "lines.");
      return point;
    }
  } // namespace



  std::vector<ProfileLine>
  read_profile_lines(const std::string &text, const Point<2> &axis)
  {
    std::vector<ProfileLine> lines;
    for (const std::string &line : split(lines_entry, text, '|'))
      {
        const auto     ends  = split(lines_entry, line, ';');
        const Point<2> begin = read_end_of_line(ends[0], line);
        const Point<2> end =
          read_end_of_line(ends.size() == 2 ? ends[1] : "", line);
        const double length = begin.distance(end);
        if (length == 0.)
          throw InputError(lines_entry, line, "both ends are the same point.");
        lines.push_back({begin, (end - begin) / length, 0., length});
      }
    if (lines.empty())
      lines.push_back({axis, Point<2>::unit_vector(0)});
    return lines;
  }
} // namespace ElastoPlastic
