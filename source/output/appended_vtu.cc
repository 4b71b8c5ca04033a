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

    /// Points, connectivity, offsets, types: the arrays of a piece before its
    /// fields.
    constexpr unsigned int n_arrays_of_grid = 4;

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



    /// Whether compression makes samples of @p data less than half as large.
    /// (It does not if they are stresses, say, whose digits are all different.)
    bool
    is_compressible(const std::vector<Bytef> &data)
    {
      constexpr std::size_t n_samples = 4, sample_size = 1024;
      if (data.size() <= n_samples * sample_size)
        return true;
      std::vector<Bytef> samples;
      for (std::size_t i = 0; i < n_samples; ++i)
        {
          const auto begin =
            data.begin() + (data.size() - sample_size) * i / (n_samples - 1);
          samples.insert(samples.end(), begin, begin + sample_size);
        }
      return 2 * compress_block(samples.data(), samples.size(), Z_BEST_SPEED)
                   .size() <
             samples.size();
    }



    /// @p data as the file has them: their number of blocks, two sizes before
    /// compression (that of the last one is zero if it is full), the size of
    /// each block after it, and the blocks.
    std::vector<Bytef>
    compress(const std::vector<Bytef> &data)
    {
      const int level = is_compressible(data) ? Z_BEST_SPEED : Z_NO_COMPRESSION;
      std::vector<std::uint32_t> header = {
        0, block_size, static_cast<std::uint32_t>(data.size() % block_size)};
      std::vector<Bytef> blocks;
      for (std::size_t begin = 0; begin < data.size(); begin += block_size)
        {
          const auto block =
            compress_block(data.data() + begin,
                           std::min<std::size_t>(block_size,
                                                 data.size() - begin),
                           level);
          header.push_back(block.size());
          blocks.insert(blocks.end(), block.begin(), block.end());
        }
      header[0]               = header.size() - 3;
      const auto *const begin = reinterpret_cast<const Bytef *>(header.data());
      blocks.insert(blocks.begin(),
                    begin,
                    begin + header.size() * sizeof(header[0]));
      return blocks;
    }
  } // namespace



  AppendedVtu::AppendedVtu(std::ostream                 &out,
                           const std::vector<Field>     &fields,
                           const std::vector<PieceSize> &sizes)
    : out(out)
    , last_piece(n_arrays_of_grid + fields.size())
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



  template <typename Number>
  void
  AppendedVtu::write_numbers(const std::vector<Number> &numbers)
  {
    Array      &last  = last_piece[offsets.size() % last_piece.size()];
    const auto *begin = reinterpret_cast<const unsigned char *>(numbers.data());
    const auto *end   = begin + numbers.size() * sizeof(Number);
    if (last.compressed.empty() ||
        !std::equal(begin, end, last.data.begin(), last.data.end()))
      {
        last.data.assign(begin, end);
        last.compressed = compress(last.data);
      }
    offsets.push_back(out.tellp() - begin_of_numbers);
    out.write(reinterpret_cast<const char *>(last.compressed.data()),
              last.compressed.size());
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
