// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_memory_h
#define base_memory_h

#include <string>

#include <mpi.h>

namespace ElastoPlastic
{
  /// The most memory that the processes have held until now, all together, in
  /// MB. Collective.
  double
  peak_memory(const MPI_Comm communicator);



  /// The memory of the machines that the processes run on, in bytes; of a
  /// machine with other processes beside them, all the same. Collective.
  double
  machine_memory(const MPI_Comm communicator);



  /// Compares what somebody is about to ask for with the machine's memory, of
  /// which this process holds some already. Linux promises more than there is,
  /// and ends processes that use it.
  /// @param purpose says what for, in a clause like "to factorise a matrix".
  /// @throws FileError if the @p bytes do not fit.
  void
  require_memory(const double bytes, const std::string &purpose);
} // namespace ElastoPlastic

#endif
