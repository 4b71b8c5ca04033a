// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Indenters read from images and text: the same heights in every format,
// interpolation, size and sides, and what is refused. The files are written
// into the working directory first.

#include <deal.II/base/mpi.h>

#include <boost/crc.hpp>

#include <cstdint>
#include <fstream>
#include <iostream>

#include "contact/gap_function.h"
#include "indenter/indenter_parameters.h"
#include "refused_indenter.h"

#include <png.h>

using namespace ElastoPlastic;

void
write(const std::string &name, const std::string &content)
{
  std::ofstream(name, std::ios::binary) << content;
}



std::string
read(const std::string &name)
{
  std::ifstream stream(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}



/// Pixels of three columns and two rows in one of libpng's memory formats.
template <typename T>
void
write_png(const std::string    &name,
          const unsigned int    format,
          const std::vector<T> &pixels,
          const std::vector<T> &palette = {})
{
  png_image image        = {};
  image.version          = PNG_IMAGE_VERSION;
  image.width            = 3;
  image.height           = 2;
  image.format           = format;
  image.colormap_entries = palette.size() / 3;
  png_image_write_to_file(
    &image, name.c_str(), 0, pixels.data(), 0, palette.data());
}



std::string
big_endian(const std::uint32_t number)
{
  std::string bytes;
  for (const unsigned int shift : {24, 16, 8, 0})
    bytes += static_cast<char>(number >> shift);
  return bytes;
}



/// The content of a PNG image without the last colour of its palette.
std::string
without_last_colour(const std::string &png)
{
  const std::size_t  begin   = png.find("PLTE");
  const std::size_t  n_bytes = static_cast<unsigned char>(png[begin - 1]);
  const std::string  chunk   = png.substr(begin, 4 + n_bytes - 3);
  boost::crc_32_type checksum;
  checksum.process_bytes(chunk.data(), chunk.size());
  return png.substr(0, begin - 4) + big_endian(n_bytes - 3) + chunk +
         big_endian(checksum.checksum()) + png.substr(begin + 4 + n_bytes + 4);
}



IndenterParameters
height_map(const std::string &type, const std::string &file)
{
  IndenterParameters parameters;
  parameters.type = type;
  parameters.file = file;
  parameters.size = {4, 2};
  return parameters;
}



/// Heights at the six pixels, row by row from the top, then in the middle of
/// the four pixels at the top left, then outside.
void
print_heights(const IndenterParameters &parameters)
{
  parameters.check(3);
  const GapFunction<3> gap(make_indenter<3>(parameters), 0, 1);

  std::cout << "  " << parameters.file << ":";
  for (const double y : {1., -1.})
    for (const double x : {-2., 0., 2.})
      std::cout << ' ' << gap.value(Point<3>(x, y, 0));
  std::cout << ", " << gap.value(Point<3>(-1, 0, 0)) << ", "
            << gap.value(Point<3>(2.1, 0, 0)) << ' '
            << gap.value(Point<3>(0, -1.1, 0)) << std::endl;
}



void
print_images()
{
  std::cout << "Images, 0 102 51 / 255 204 153 of 255" << std::endl;
  using Bytes              = std::vector<png_byte>;
  const Bytes  greys       = {0, 102, 51, 255, 204, 153};
  const double white_in_8  = 255;
  const double white_in_16 = 65535;

  Bytes                    colours, transparent;
  std::vector<png_uint_16> wide;
  for (const png_byte grey : greys)
    {
      colours.insert(colours.end(), 3, grey);
      transparent.insert(transparent.end(), 3, grey);
      transparent.push_back(7 * (transparent.size() + 1));
      wide.push_back(grey * white_in_16 / white_in_8);
    }
  write_png("grey_8.png", PNG_FORMAT_GRAY, greys);
  write_png("grey_16.png", PNG_FORMAT_LINEAR_Y, wide);
  write_png("colour.png", PNG_FORMAT_RGB, colours);
  write_png("transparent.png", PNG_FORMAT_RGBA, transparent);
  write_png("palette.png",
            PNG_FORMAT_RGB_COLORMAP,
            Bytes{0, 1, 2, 3, 4, 5},
            colours);

  write("plain.pgm", "P2 # comment\n# another\n3 2 5\n0 2 1\n5 #five\n4 3\n");
  write("raw_8.pgm", std::string("P5\n3 2\n255\n\x00\x66\x33\xff\xcc\x99", 17));
  write("raw_16.pgm",
        std::string("P5 3 2 256\n"
                    "\x00\x00\x00\x66\x00\x33\x01\x00\x00\xcc\x00\x99",
                    23));

  for (const std::string name : {"grey_8.png",
                                 "grey_16.png",
                                 "colour.png",
                                 "transparent.png",
                                 "palette.png",
                                 "plain.pgm",
                                 "raw_8.pgm",
                                 "raw_16.pgm"})
    print_heights(height_map("image", name));

  write_png(
    "luma.png",
    PNG_FORMAT_RGB,
    Bytes{0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 0, 0, 0, 0});
  print_heights(height_map("image", "luma.png"));

  std::cout << "Bitmaps, black is 1: 101 / 001" << std::endl;
  write("plain.pbm", "P1\n3 2\n101\n0 0 1\n");
  write("raw.pbm", "P4\n3 2\n\xa0\x20");
  print_heights(height_map("image", "plain.pbm"));
  print_heights(height_map("image", "raw.pbm"));
}



void
print_matrices()
{
  std::cout << "Matrices and sides" << std::endl;
  write("spaces.txt", "# heights\n10 12 11\n\n15\t14 13 # last\n");
  write("commas.csv", "10, 12, 11\r\n15, 14, 13\r\n");
  IndenterParameters matrix = height_map("height matrix", "spaces.txt");
  print_heights(matrix);
  matrix.side_down    = SideDown::light;
  matrix.height_scale = 0.5;
  matrix.file         = "commas.csv";
  print_heights(matrix);

  IndenterParameters image = height_map("image", "plain.pgm");
  image.side_down          = SideDown::light;
  image.height_scale       = 10;
  print_heights(image);

  write("profile.txt", "3 1 2");
  IndenterParameters profile = height_map("height matrix", "profile.txt");
  profile.size               = {4};
  profile.position           = {1};
  const GapFunction<2> gap(make_indenter<2>(profile), 0, 1);
  std::cout << "  profile.txt:";
  for (const double x : {-1.1, -1., 0., 1., 2., 3., 3.1})
    std::cout << ' ' << gap.value(Point<2>(x, 0));
  std::cout << std::endl;
}



void
print_image_errors()
{
  std::cout << "Images that are refused" << std::endl;
  const auto refuse = [](const std::string &name, const std::string &content) {
    write(name, content);
    print_refusal(height_map("image", name), 3);
  };

  print_refusal(height_map("image", ""), 3);
  print_refusal(height_map("image", "missing.png"), 3);
  print_refusal(height_map("image", "."), 3);
  refuse("empty.png", "");
  refuse("text.png", "1 2\n3 4\n");
  refuse("photo.png", "\xff\xd8\xff\xe0 JFIF");
  refuse("colour.ppm", "P6 1 1 255\nabc");

  const std::string png = read("grey_8.png");
  refuse("header_only.png", png.substr(0, 20));
  refuse("truncated.png", png.substr(0, png.size() - 20));
  std::string damaged = png;
  damaged[19] += 1; // the width, so the checksum of the header is wrong
  refuse("damaged.png", damaged);
  refuse("short_palette.png", without_last_colour(read("palette.png")));

  refuse("huge.png",
         png.substr(0, 8) + std::string("\x00\x00\x00\x0dIHDR"
                                        "\x00\x00\xea\x60"
                                        "\x00\x00\xea\x60"
                                        "\x08\x00\x00\x00\x00"
                                        "\xa5\xb9\x2a\x9e"
                                        "\x00\x00\x00\x03"
                                        "IDAT",
                                        33));

  // A chunk that claims 1.6 GB
  refuse("long_chunk.png",
         png.substr(0, 33) + std::string("\x65\x00\x00\x00"
                                         "eXIfMM\x00*",
                                         12));

  refuse("no_size.pgm", "P5");
  refuse("no_maximum.pgm", "P5 2 2");
  refuse("zero.pgm", "P5 0 2 255\n");
  refuse("huge.pgm", "P5 100000 100000 255\n");
  refuse("overflow.pgm", "P5 99999999999999999999 2 255\n");
  refuse("negative.pgm", "P5 -2 2 255\n");
  refuse("maximum_0.pgm", "P5 2 2 0\n1234");
  refuse("maximum_70000.pgm", "P5 2 2 70000\n12345678");
  refuse("short.pgm", "P5 2 2 255\n123");
  refuse("short_16.pgm", "P5 2 2 256\n1234567");
  refuse("short_plain.pgm", "P2 2 2 255\n10 20 30\n");
  refuse("too_bright.pgm", "P2 2 2 9\n1 2 3 10\n");
  refuse("letters.pgm", "P2 2 2 9\n1 2 x 4\n");
  refuse("digit.pbm", "P1 2 2\n0120");
  refuse("short.pbm", "P4 9 2\n123");
  refuse("single_row.pgm", "P2 3 1 9\n1 2 3\n");
  print_refusal(height_map("image", "grey_8.png"), 2);

  IndenterParameters profile = height_map("image", "grey_8.png");
  profile.size               = {4};
  print_refusal(profile, 2);
  print_refusal(profile, 3);
}



void
print_matrix_errors()
{
  std::cout << "Matrices that are refused" << std::endl;
  const auto refuse = [](const std::string &content) {
    write("matrix.txt", content);
    print_refusal(height_map("height matrix", "matrix.txt"), 3);
  };

  refuse("");
  refuse("# nothing\n");
  refuse("1 2\n3 4 5\n");
  refuse("1 2\n3 four\n");
  refuse("1 2\n3 4.5.6\n");
  refuse("1 2\nnan 4\n");
  refuse("1 inf\n3 4\n");
  refuse("1 1e999\n3 4\n");
  refuse("1,,2\n3,4,5\n");
  refuse("1 2\n0,12 0,13\n");
  refuse("1 2\n");
  refuse("1\n2\n");
  refuse(std::string("1 2\n3 4\0 5", 10));
  refuse(read("grey_8.png"));
}



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  print_images();
  print_matrices();
  print_image_errors();
  print_matrix_errors();
}
