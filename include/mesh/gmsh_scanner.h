// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_gmsh_scanner_h
#define mesh_gmsh_scanner_h

#include <string>

namespace ElastoPlastic
{
  /// Reads a text file word by word and knows where it is, so that whatever is
  /// wrong with the file becomes an InputError with the line it is in.
  class GmshScanner
  {
  public:
    /// @throws InputError if the file cannot be read.
    explicit GmshScanner(const std::string &file_name);

    bool
    at_end() const
    {
      return position == text.size();
    }

    /// The next word; a text in double quotes is one word, without the quotes.
    std::string
    word();

    /// The next word as an integer.
    long
    integer();

    /// The next word as an integer >= 0 that fits into 32 bits.
    unsigned int
    count();

    /// The next word as a finite number.
    double
    number();

    /// Pass the next word, which must be this one.
    void
    expect(const std::string &word);

    /// Pass everything up to and including this word.
    void
    skip_past(const std::string &word);

    /// @throws InputError that names the file and the line of the last word;
    /// @p reason completes the sentence "in line 7 of this file ...".
    [[noreturn]] void
    fail(const std::string &reason) const;

  private:
    void
    skip_white_space();

    std::string  file_name;
    std::string  text;
    std::size_t  position     = 0;
    unsigned int line         = 1;
    unsigned int line_of_word = 1; ///< of the last one read
  };



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
