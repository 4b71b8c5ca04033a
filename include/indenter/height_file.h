// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_height_file_h
#define indenter_height_file_h

#include <deal.II/base/point.h>
#include <deal.II/base/table.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/text.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A whole input file in memory, with what an error message about it needs.
  class HeightFile
  {
  public:
    /// Read the file, which all ranks do together. @p path is the entry that
    /// names it. A file that cannot be read is an InputError.
    HeightFile(const std::string &path, const std::string &name)
      : path(path)
      , name(name)
      , content(read_input_file(path, name))
    {}


    /// Throw an InputError about this file. @p what completes "..., but ".
    [[noreturn]] void
    reject(const std::string &what) const;

    /// Reject a header that promises no pixel or more than 3*10^7, whose
    /// heights take 240 MB on every rank.
    void
    check_n_pixels(const std::size_t width, const std::size_t height) const;

    /// The content of a text file, with '\n' at the ends of lines. What is no
    /// plain text is rejected.
    std::string
    text() const;

    /// Whether the file begins with these bytes.
    bool
    begins_with(const std::string &signature) const
    {
      return content.compare(0, signature.size(), signature) == 0;
    }

    const std::string path;
    const std::string name;
    const std::string content;
  };



  /// The pixels of a PNG, PGM or PBM image, from 0 (black) to 1 (white), by row
  /// and column, the top row first. The first bytes of the file tell the
  /// format, not its name. Any other format is an InputError.
  Table<2, double>
  decode_image(const HeightFile &file);



  /// The pixels of a PNG image of any kind, from 0 (black) to 1 (white), by row
  /// and column. Colours become their luma, 0.299 R + 0.587 G + 0.114 B;
  /// transparency and gamma are ignored. libpng is called directly because
  /// Boost.GIL reads past the end of a truncated file, prints to standard error
  /// and blends colours with their transparency. What is wrong in the file is
  /// an InputError.
  Table<2, double>
  decode_png(const HeightFile &file);



  /// The pixels of a PBM or PGM image (types P1, P2, P4, P5; up to 16 bit),
  /// from 0 (black) to 1 (white), by row and column. Boost.GIL is not used: in
  /// version 1.74 it knows no 16 bit, does not scale by the largest grey, and
  /// does not notice a truncated file. What is wrong in the file is an
  /// InputError. The format: netpbm.sourceforge.net/doc/{pbm,pgm}.html.
  Table<2, double>
  decode_pnm(const HeightFile &file);



  /// A matrix of numbers from text: a row per line, numbers separated by white
  /// space or commas, '#' begins a comment, lines without numbers are skipped.
  /// Rows of different length and what is not a finite number are
  /// InputErrors that name the line.
  Table<2, double>
  decode_matrix(const HeightFile &file);



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
