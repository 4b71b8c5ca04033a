// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <csetjmp>
#include <cstddef>
#include <string>
#include <vector>

#include "indenter/height_file.h"

#include <png.h>

namespace ElastoPlastic
{
  namespace
  {
    /// libpng's reading functions behind one that owns its structures and
    /// reports errors by a return value: its errors are long jumps, so no
    /// object with a destructor may live in a function that calls it.
    class PngReader
    {
    public:
      explicit PngReader(const std::string &content)
        : next(content.data())
        , n_bytes_left(content.size())
        , png(png_create_read_struct(PNG_LIBPNG_VER_STRING,
                                     this,
                                     &PngReader::jump_out,
                                     [](png_structp,
                                        png_const_charp /*warning*/) {}))
        , info(png_create_info_struct(png))
      {
        AssertThrow(png != nullptr && info != nullptr, ExcOutOfMemory(0));
        png_set_read_fn(png, this, &PngReader::copy_bytes);
        // Texts and colour profiles may claim any size: libpng would reserve
        // it.
        png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
      }

      PngReader(const PngReader &) = delete;

      ~PngReader()
      {
        png_destroy_read_struct(&png, &info, nullptr);
      }

      /// Read up to the pixels. False on an error.
      bool
      read_header()
      {
        if (setjmp(png_jmpbuf(png)))
          return false;
        png_read_info(png, info);
        return true;
      }

      /// Make room for rows of pixels with 16 bit per channel, without
      /// transparency; where there is a palette, of its indices with 8 bit.
      /// False on an error.
      bool
      prepare_rows()
      {
        if (setjmp(png_jmpbuf(png)))
          return false;
        if (has_palette())
          png_set_packing(png);
        else
          png_set_expand_16(png);
        png_set_strip_alpha(png);
        png_set_interlace_handling(png);
        png_read_update_info(png, info);
        return true;
      }

      /// Read the pixels into rows of n_bytes_per_row(). False on an error.
      bool
      read_pixels(png_bytepp rows)
      {
        if (setjmp(png_jmpbuf(png)))
          return false;
        png_read_image(png, rows);
        png_read_end(png, nullptr);
        return true;
      }

      std::size_t
      width() const
      {
        return png_get_image_width(png, info);
      }

      std::size_t
      height() const
      {
        return png_get_image_height(png, info);
      }

      bool
      has_palette() const
      {
        return png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE;
      }

      std::vector<png_color>
      palette() const
      {
        png_colorp colors   = nullptr;
        int        n_colors = 0;
        png_get_PLTE(png, info, &colors, &n_colors);
        return {colors, colors + n_colors};
      }

      unsigned int
      n_channels() const
      {
        return png_get_channels(png, info);
      }

      std::size_t
      n_bytes_per_row() const
      {
        return png_get_rowbytes(png, info);
      }

      const std::string &
      error() const
      {
        return message;
      }

    private:
      [[noreturn]] static void
      jump_out(png_structp png, png_const_charp message)
      {
        static_cast<PngReader *>(png_get_error_ptr(png))->message = message;
        png_longjmp(png, 1);
      }

      static void
      copy_bytes(png_structp png, png_bytep target, std::size_t n_bytes)
      {
        PngReader &reader = *static_cast<PngReader *>(png_get_io_ptr(png));
        if (n_bytes > reader.n_bytes_left)
          png_error(png, "the file ends too early");
        std::copy_n(reader.next, n_bytes, target);
        reader.next += n_bytes;
        reader.n_bytes_left -= n_bytes;
      }

      const char *next;
      std::size_t n_bytes_left;
      std::string message;
      png_structp png;
      png_infop   info;
    };



    double
    luma(const double red, const double green, const double blue)
    {
      return 0.299 * red + 0.587 * green + 0.114 * blue;
    }



    /// Between 0 and 1, from one or three channels of 16 bit, high byte first.
    double
    grey(const png_byte *const pixel, const unsigned int n_channels)
    {
      const auto channel = [pixel](const unsigned int c) {
        return (256 * pixel[2 * c] + pixel[2 * c + 1]) / 65535.;
      };
      return n_channels == 1 ? channel(0) :
                               luma(channel(0), channel(1), channel(2));
    }



    // (libpng takes black for colours that a palette does not have.)
    std::vector<double>
    greys_from_palette(const HeightFile             &file,
                       const std::vector<png_color> &palette,
                       const std::vector<png_byte>  &indices)
    {
      std::vector<double> greys;
      greys.reserve(indices.size());
      for (const png_byte index : indices)
        {
          if (index >= palette.size())
            file.reject("this PNG image has a pixel of the colour " +
                        std::to_string(index) + ", which its palette of " +
                        std::to_string(palette.size()) +
                        " colours does not have. It is damaged.");
          const png_color &color = palette[index];
          greys.push_back(luma(color.red, color.green, color.blue) / 255.);
        }
      return greys;
    }
  } // namespace



  Table<2, double>
  decode_png(const HeightFile &file)
  {
    PngReader  reader(file.content);
    const auto reject = [&]() {
      file.reject("this PNG image is damaged or truncated (" + reader.error() +
                  ").");
    };
    if (!reader.read_header())
      reject();
    const std::size_t width = reader.width(), height = reader.height();
    file.check_n_pixels(width, height);
    constexpr std::size_t largest_compression = 1032; // of zlib
    if (width * height / 8 > largest_compression * file.content.size())
      file.reject(
        "this PNG image is damaged or truncated (its header promises "
        "more pixels than the file can hold).");
    if (!reader.prepare_rows())
      reject();

    std::vector<png_byte>  bytes(height * reader.n_bytes_per_row());
    std::vector<png_bytep> rows(height);
    for (std::size_t row = 0; row < height; ++row)
      rows[row] = bytes.data() + row * reader.n_bytes_per_row();
    if (!reader.read_pixels(rows.data()))
      reject();

    if (reader.has_palette())
      return {height,
              width,
              greys_from_palette(file, reader.palette(), bytes).begin()};
    const unsigned int n_channels = reader.n_channels();
    Table<2, double>   greys(height, width);
    for (std::size_t row = 0; row < height; ++row)
      for (std::size_t column = 0; column < width; ++column)
        greys(row, column) =
          grey(rows[row] + 2 * n_channels * column, n_channels);
    return greys;
  }
} // namespace ElastoPlastic
