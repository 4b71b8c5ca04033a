// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_termination_h
#define base_termination_h

#include <mpi.h>

namespace ElastoPlastic
{
  /// From now on the signal SIGTERM does not end the program, but is noted.
  void
  note_termination_requests();

  /// Whether this rank has received SIGTERM since.
  bool
  termination_requested_here();

  /// Whether any rank has received SIGTERM since. All ranks call this, and all
  /// get the same answer.
  bool
  termination_requested(const MPI_Comm communicator);
} // namespace ElastoPlastic

#endif
