// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_damage_h
#define tests_damage_h

#include <boost/crc.hpp>

#include <random>
#include <string>
#include <vector>

#include <png.h>

// Random changes of good input; the same ones with the same seed.

using Random = std::mt19937;



inline std::string
png_image_of(const png_uint_32 format)
{
  const std::vector<png_byte> pixels(64, 100);
  png_image                   image = {};
  image.version                     = PNG_IMAGE_VERSION;
  image.width                       = 4;
  image.height                      = 3;
  image.format                      = format;
  png_alloc_size_t size             = 10000;
  std::string      bytes(size, '\0');
  png_image_write_to_memory(
    &image, bytes.data(), &size, 0, pixels.data(), 0, nullptr);
  return bytes.substr(0, size);
}



/// Gives the chunks of a PNG file the checksums of what they hold, as far as
/// its lengths lead; otherwise libpng looks no further.
inline std::string
with_checksums(std::string bytes)
{
  std::size_t position = 8;
  while (position + 12 <= bytes.size())
    {
      const auto byte = [&](const unsigned int i) {
        return std::size_t(static_cast<unsigned char>(bytes[position + i]));
      };
      const std::size_t length =
        byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3);
      if (length > bytes.size() - position - 12)
        break;
      boost::crc_32_type checksum;
      checksum.process_bytes(&bytes[position + 4], length + 4);
      position += length + 8;
      for (const int shift : {24, 16, 8, 0})
        bytes[position++] = checksum.checksum() >> shift;
    }
  return bytes;
}



inline std::size_t
below(const std::size_t n, Random &random)
{
  return n == 0 ? 0 : random() % n;
}



/// One change anywhere. @p others are good inputs of the same kind.
inline void
damage(std::string                    &text,
       const std::vector<std::string> &others,
       Random                         &random)
{
  static const std::vector<std::string> words = {
    "-1",   "0",   "1",      "2147483648", "4294967295", "18446744073709551616",
    "1e99", "nan", "1e-320", "inf",        "1,5",        "\n",
    " ",    "#",   "\"",     ":",          "|",          ";",
    "{",    "(",   "=",      "\\",         "set",        "end"};
  const std::string &other    = others[below(others.size(), random)];
  const std::size_t  position = below(text.size() + 1, random);
  const std::size_t  length =
    std::min(text.size() - position, below(16, random) + 1);
  const std::size_t from = below(other.size(), random);
  switch (random() % 7)
    {
      case 0:
        if (position < text.size())
          text[position] ^= 1 << random() % 8;
        break;
      case 1:
        if (position < text.size())
          text[position] = random() % 256;
        break;
      case 2:
        text.erase(position, length);
        break;
      case 3:
        text.insert(position, text.substr(position, length));
        break;
      case 4:
        text.replace(position, length, words[below(words.size(), random)]);
        break;
      case 5:
        text.replace(position, length, other.substr(from, length));
        break;
      case 6:
        if (random() % 4 == 0)
          text.resize(position);
        break;
    }
}

#endif
