// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "contact/decode_image.h"
#include "contact/decode_png.h"
#include "contact/decode_pnm.h"

namespace ElastoPlastic
{
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
