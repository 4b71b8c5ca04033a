// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "base/exceptions.h"
#include "base/text.h"
#include "indenter/height_file.h"

namespace ElastoPlastic
{
  void
  HeightFile::reject(const std::string &what) const
  {
    throw InputError(path, name, what);
  }



  void
  HeightFile::check_n_pixels(const std::size_t width,
                             const std::size_t height) const
  {
    constexpr std::size_t n_pixels_max = 30'000'000;
    if (width == 0 || height == 0 || width > n_pixels_max / height)
      reject("the header of this image promises " + std::to_string(width) +
             " x " + std::to_string(height) +
             " pixels. Between 1 and 3*10^7 can be read: choose a coarser "
             "resolution.");
  }



  std::string
  HeightFile::text() const
  {
    return plain_text(content, [this](const std::string &what) {
      reject("this file " + what);
    });
  }



  Table<2, double>
  decode_image(const HeightFile &file)
  {
    if (file.begins_with("\x89PNG\r\n\x1a\n"))
      return decode_png(file);
    for (const char *const signature : {"P1", "P2", "P4", "P5"})
      if (file.begins_with(signature))
        return decode_pnm(file);
    file.reject(
      "its content is neither a PNG nor a PGM nor a PBM image, "
      "whatever its name says. Convert it to one of these; a text "
      "file with numbers needs 'Indenter/Type = height matrix'.");
  }
} // namespace ElastoPlastic
