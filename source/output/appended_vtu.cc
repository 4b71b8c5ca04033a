// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/config.h>
#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cstdint>
#include <iomanip>

#include "output/appended_vtu.h"

#include <zlib.h>

namespace ElastoPlastic
{
  namespace
  {
    using namespace dealii;

    constexpr unsigned int block_size = 1 << 16; // bytes, before compression
    constexpr int          digits_of_offset = 16;

    const AppendedVtu::Field point_field = {"", 3, ""};



    /// The first lines of a file that holds such a @p data_set.
    std::string
    begin_of_file(const std::string &data_set)
    {
      const std::string byte_order =
#ifdef DEAL_II_WORDS_BIGENDIAN
        "BigEndian";
#else
        "LittleEndian";
#endif
      return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + data_set +
             "\" version=\"0.1\" byte_order=\"" + byte_order +
             "\" compressor=\"vtkZLibDataCompressor\">\n<" + data_set + ">\n";
    }



    std::string
    attributes(const AppendedVtu::Field &field, const std::string &type)
    {
      std::string text = " type=\"" + type + '"';
      if (!field.name.empty())
        text += " Name=\"" + field.name + '"';
      if (!field.unit.empty())
        text += " units=\"" + field.unit + '"';
      if (field.n_components > 1)
        text +=
          " NumberOfComponents=\"" + std::to_string(field.n_components) + '"';
      return text;
    }



    std::vector<Bytef>
    compress_block(const Bytef *data, const unsigned int size, const int level)
    {
      std::vector<Bytef> block(compressBound(size));
      uLongf             length = block.size();
      const int ierr = compress2(block.data(), &length, data, size, level);
      AssertThrow(ierr == Z_OK, ExcIO());
      block.resize(length);
      return block;
    }



    /// The blocks of @p data. If the first one does not become much smaller,
    /// the others are not tried: they hold stresses, say, whose digits are all
    /// different.
    std::vector<std::vector<Bytef>>
    compress_blocks(const Bytef *data, const std::size_t size)
    {
      std::vector<std::vector<Bytef>> blocks;
      int                             level = Z_BEST_SPEED;
      for (std::size_t begin = 0; begin < size; begin += block_size)
        {
          const unsigned int length =
            std::min<std::size_t>(block_size, size - begin);
          blocks.push_back(compress_block(data + begin, length, level));
          if (begin == 0 && 2 * blocks[0].size() > length)
            level = Z_NO_COMPRESSION;
        }
      return blocks;
    }
  } // namespace



  AppendedVtu::AppendedVtu(std::ostream                 &out,
                           const std::vector<Field>     &fields,
                           const std::vector<PieceSize> &sizes)
    : out(out)
  {
    out << begin_of_file("UnstructuredGrid");
    for (const auto &[n_points, n_cells] : sizes)
      {
        out << "<Piece NumberOfPoints=\"" << n_points << "\" NumberOfCells=\""
            << n_cells << "\">\n<Points>\n";
        declare(point_field, "Float32");
        out << "</Points>\n<Cells>\n";
        declare({"connectivity", 1, ""}, "Int32");
        declare({"offsets", 1, ""}, "Int32");
        declare({"types", 1, ""}, "UInt8");
        out << "</Cells>\n<PointData>\n";
        for (const Field &field : fields)
          declare(field, "Float32");
        out << "</PointData>\n</Piece>\n";
      }
    out << "</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    begin_of_numbers = out.tellp();
  }



  void
  AppendedVtu::declare(const Field &field, const std::string &type)
  {
    out << "<DataArray" << attributes(field, type)
        << " format=\"appended\" offset=\"";
    places.push_back(out.tellp());
    out << std::string(digits_of_offset, '0') << "\"/>\n";
  }



  // Before the blocks: their number, two sizes before compression (that of the
  // last one is zero if it is full), and the size of each after it.
  template <typename Number>
  void
  AppendedVtu::write_numbers(const std::vector<Number> &numbers)
  {
    offsets.push_back(out.tellp() - begin_of_numbers);
    const std::size_t size = numbers.size() * sizeof(Number);
    const auto        blocks =
      compress_blocks(reinterpret_cast<const Bytef *>(numbers.data()), size);
    std::vector<std::uint32_t> header = {
      static_cast<std::uint32_t>(blocks.size()),
      block_size,
      static_cast<std::uint32_t>(size % block_size)};
    for (const auto &block : blocks)
      header.push_back(block.size());
    out.write(reinterpret_cast<const char *>(header.data()),
              header.size() * sizeof(header[0]));
    for (const auto &block : blocks)
      out.write(reinterpret_cast<const char *>(block.data()), block.size());
  }



  void
  AppendedVtu::write(const Piece &piece)
  {
    write_numbers(piece.points);
    write_numbers(piece.connectivity);
    write_numbers(piece.offsets);
    write_numbers(piece.types);
    for (const auto &field : piece.fields)
      write_numbers(field);
  }



  void
  AppendedVtu::finish()
  {
    Assert(!out || offsets.size() == places.size(), ExcInternalError());
    out << "\n</AppendedData>\n</VTKFile>\n" << std::setfill('0');
    for (unsigned int i = 0; i < offsets.size(); ++i)
      {
        out.seekp(places[i]);
        out << std::setw(digits_of_offset) << offsets[i];
      }
  }



  void
  AppendedVtu::write_index(std::ostream                   &out,
                           const std::vector<Field>       &fields,
                           const std::vector<std::string> &file_names)
  {
    out << begin_of_file("PUnstructuredGrid") << "<PPointData>\n";
    for (const Field &field : fields)
      out << "<PDataArray" << attributes(field, "Float32") << "/>\n";
    out << "</PPointData>\n<PPoints>\n<PDataArray"
        << attributes(point_field, "Float32") << "/>\n</PPoints>\n";
    for (const std::string &name : file_names)
      out << "<Piece Source=\"" << name << "\"/>\n";
    out << "</PUnstructuredGrid>\n</VTKFile>\n";
  }
} // namespace ElastoPlastic
