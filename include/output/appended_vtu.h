// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_appended_vtu_h
#define output_appended_vtu_h

#include <ostream>
#include <string>
#include <vector>

namespace ElastoPlastic
{
  /// A file of VTK's unstructured grids (.vtu) whose numbers stand behind the
  /// XML as they are in memory, compressed where that makes them much smaller:
  /// "appended", "raw" and "vtkZLibDataCompressor" in VTK's words. deal.II's
  /// writer compresses everything and writes it in base64, which takes several
  /// times as long.
  ///
  /// The grid comes in pieces, one after the other, so that memory for one of
  /// them is enough. Where the numbers of each are is filled in later, so @p
  /// out must be seekable.
  class AppendedVtu
  {
  public:
    /// Single precision numbers at the points.
    struct Field
    {
      std::string  name;
      unsigned int n_components;
      std::string  unit; ///< may be empty
    };

    struct PieceSize
    {
      unsigned int n_points, n_cells;
    };

    /// One part of the grid: numbers in the order in which they are written.
    struct Piece
    {
      std::vector<float>              points; ///< x, y, z of each
      std::vector<int>                connectivity;
      std::vector<int>                offsets; ///< ends in connectivity
      std::vector<unsigned char>      types;   ///< VTK's cell types
      std::vector<std::vector<float>> fields;
    };

    /// Writes the XML. @p sizes are those of the pieces to come.
    AppendedVtu(std::ostream                 &out,
                const std::vector<Field>     &fields,
                const std::vector<PieceSize> &sizes);

    /// Writes the next piece.
    void
    write(const Piece &piece);

    /// To be called after the last one.
    void
    finish();

    /// Writes the file (.pvtu) that puts those of several ranks together.
    static void
    write_index(std::ostream                   &out,
                const std::vector<Field>       &fields,
                const std::vector<std::string> &file_names);

  private:
    void
    declare(const Field &field, const std::string &type);

    template <typename Number>
    void
    write_numbers(const std::vector<Number> &numbers);

    /// Numbers as they are in memory, and as the file has them.
    struct Array
    {
      std::vector<unsigned char> data, compressed;
    };

    std::ostream &out;

    /// The arrays of the last piece: what is the same in the next one, such as
    /// the connectivity, is not compressed again.
    std::vector<Array> last_piece;

    /// Where the offset of each array belongs, and those known so far.
    std::vector<std::streampos> places;
    std::vector<std::streamoff> offsets;
    std::streampos              begin_of_numbers;
  };
} // namespace ElastoPlastic

#endif
