// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef app_program_h
#define app_program_h

namespace ElastoPlastic
{
  /// Does what the command line asks for, on all ranks of MPI_COMM_WORLD.
  /// Errors are printed on standard error, once.
  /// @return the program's exit status, an ExitStatus.
  int
  run_program(const int argc, const char *const *const argv);
} // namespace ElastoPlastic

#endif
