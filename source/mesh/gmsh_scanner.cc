// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "base/exceptions.h"
#include "base/text.h"
#include "mesh/gmsh_scanner.h"

namespace ElastoPlastic
{
  namespace
  {
    bool
    is_space(const char c)
    {
      return std::isspace(static_cast<unsigned char>(c)) != 0;
    }



    /// The whole word must be the number: "12abc" is none.
    template <typename Number>
    bool
    convert(const std::string &word, Number &value)
    {
      const char *const end    = word.data() + word.size();
      const auto [rest, error] = std::from_chars(word.data(), end, value);
      return error == std::errc() && rest == end;
    }



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



  GmshScanner::GmshScanner(const std::string &file_name)
    : file_name(file_name)
    , text(plain_text(read_input_file("Geometry/File", file_name),
                      [&](const std::string &what) {
                        throw InputError("Geometry/File",
                                         file_name,
                                         "this file " + what);
                      }))
  {
    skip_white_space();
  }



  std::string
  GmshScanner::word()
  {
    line_of_word = line;
    if (at_end())
      fail("it ends too early: is it truncated?");

    std::size_t begin = position, end = position;
    if (text[position] == '"')
      {
        ++begin;
        end = text.find_first_of("\"\n", begin);
        if (end == std::string::npos || text[end] != '"')
          fail("a closing quote is missing.");
        position = end + 1;
      }
    else
      {
        while (end < text.size() && !is_space(text[end]))
          ++end;
        position = end;
      }
    const std::string result = text.substr(begin, end - begin);
    skip_white_space();
    return result;
  }



  long
  GmshScanner::integer()
  {
    const std::string text_of_value = word();
    long              value         = 0;
    if (!convert(text_of_value, value))
      fail("there is '" + text_of_value + "' where a whole number should be.");
    return value;
  }



  unsigned int
  GmshScanner::count()
  {
    const long value = integer();
    if (value < 0 || value > std::numeric_limits<unsigned int>::max())
      fail("there is '" + std::to_string(value) +
           "' where a number of things should be.");
    return value;
  }



  double
  GmshScanner::number()
  {
    const std::string text_of_value = word();
    double            value         = 0;
    if (!convert(text_of_value, value) || !std::isfinite(value))
      fail("there is '" + text_of_value + "' where a number should be.");
    return value;
  }



  void
  GmshScanner::expect(const std::string &expected)
  {
    if (const std::string found = word(); found != expected)
      fail("there is '" + found + "' where '" + expected + "' should be.");
  }



  void
  GmshScanner::skip_past(const std::string &last)
  {
    while (word() != last)
      {}
  }



  void
  GmshScanner::fail(const std::string &reason) const
  {
    throw InputError("Geometry/File",
                     file_name,
                     "in line " + std::to_string(line_of_word) +
                       " of this file " + reason);
  }



  void
  GmshScanner::skip_white_space()
  {
    for (; position < text.size() && is_space(text[position]); ++position)
      line += (text[position] == '\n');
  }



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
