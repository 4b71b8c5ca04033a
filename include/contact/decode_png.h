// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_decode_png_h
#define contact_decode_png_h

#include <deal.II/base/table.h>

#include "contact/height_file.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The pixels of a PNG image of any kind, from 0 (black) to 1 (white), by row
  /// and column. Colours become their luma, 0.299 R + 0.587 G + 0.114 B;
  /// transparency and gamma are ignored. libpng is called directly because
  /// Boost.GIL reads past the end of a truncated file, prints to standard error
  /// and blends colours with their transparency. What is wrong in the file is
  /// an InputError.
  Table<2, double>
  decode_png(const HeightFile &file);
} // namespace ElastoPlastic

#endif
