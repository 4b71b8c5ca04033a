// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_decode_image_h
#define contact_decode_image_h

#include <deal.II/base/table.h>

#include "contact/height_file.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The pixels of a PNG, PGM or PBM image, from 0 (black) to 1 (white), by row
  /// and column, the top row first. The first bytes of the file tell the
  /// format, not its name. Any other format is an InputError.
  Table<2, double>
  decode_image(const HeightFile &file);
} // namespace ElastoPlastic

#endif
