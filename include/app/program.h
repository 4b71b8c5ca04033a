// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef app_program_h
#define app_program_h

#include <iosfwd>

#include <mpi.h>

namespace ElastoPlastic
{
  struct CommandLine;
  template <int dim>
  struct Model;
  struct Parameters;

  /// Does what the command line asks for, on all ranks of MPI_COMM_WORLD.
  /// Errors are printed on standard error, once.
  /// @return the program's exit status, an ExitStatus.
  int
  run_program(const int argc, const char *const *const argv);



  /// What the option --validate does: checks what can be checked before
  /// anything is computed, and writes to @p out what the job will be. That
  /// takes about a second: for a contact problem, a large mesh is not made, but
  /// one with fewer initial refinements is looked at in its place. Collective.
  /// @throws InputError, EquilibriumError, FileError
  template <int dim>
  void
  validate(const Model<dim>  &model,
           const CommandLine &command_line,
           const Parameters  &parameters,
           const MPI_Comm     communicator,
           std::ostream      &out);
} // namespace ElastoPlastic

#endif
