// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef contact_decode_matrix_h
#define contact_decode_matrix_h

#include <deal.II/base/table.h>

#include "contact/height_file.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// A matrix of numbers from text: a row per line, numbers separated by white
  /// space or commas, '#' begins a comment, lines without numbers are skipped.
  /// Rows of different length and what is not a finite number are
  /// InputErrors that name the line.
  Table<2, double>
  decode_matrix(const HeightFile &file);
} // namespace ElastoPlastic

#endif
