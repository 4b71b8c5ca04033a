// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_decode_pnm_h
#define contact_decode_pnm_h

#include <deal.II/base/table.h>

#include "contact/height_file.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// The pixels of a PBM or PGM image (types P1, P2, P4, P5; up to 16 bit),
  /// from 0 (black) to 1 (white), by row and column. Boost.GIL is not used: in
  /// version 1.74 it knows no 16 bit, does not scale by the largest grey, and
  /// does not notice a truncated file. What is wrong in the file is an
  /// InputError. The format: netpbm.sourceforge.net/doc/{pbm,pgm}.html.
  Table<2, double>
  decode_pnm(const HeightFile &file);
} // namespace ElastoPlastic

#endif
