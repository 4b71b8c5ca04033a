// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_table_reference_h
#define output_table_reference_h

#include <iosfwd>

#include "output/output_parameters.h"

#include <mpi.h>

namespace ElastoPlastic
{
  /// Writes what the columns of all tables are, and in which @p units, as a
  /// page (Markdown): doc/lookup/tables.md, if they have no names.
  void
  print_table_reference(std::ostream &out, const Units &units);



  /// Writes this page to the file tables.md in the output directory if the
  /// user has named the units. Collective. @throws FileError
  void
  write_table_reference(const MPI_Comm          communicator,
                        const OutputParameters &parameters);
} // namespace ElastoPlastic

#endif
