// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef io_output_directory_h
#define io_output_directory_h

#include <string>

#include <mpi.h>

namespace ElastoPlastic
{
  /// Makes @p directory ready to receive results: creates it, and refuses to
  /// touch earlier results, or removes them if @p overwrite. Only files that
  /// the program itself writes are ever removed. The @p effective_input goes
  /// into its file parameters.prm.
  /// @throws InputError if there are results already; FileError if the
  /// directory cannot be created or written to.
  void
  prepare_output_directory(const MPI_Comm     communicator,
                           const std::string &directory,
                           const bool         overwrite,
                           const std::string &effective_input);
} // namespace ElastoPlastic

#endif
