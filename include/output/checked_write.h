// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef output_checked_write_h
#define output_checked_write_h

#include <functional>
#include <ostream>
#include <string>

#include <mpi.h>

namespace ElastoPlastic
{
  /// Writes the file @p name with @p write on this rank, and makes sure that it
  /// is complete. Every rank calls this, with an empty @p name if it
  /// has nothing to write. @p write is called even if the file cannot be
  /// opened, and writes in vain then: it may have to answer other ranks.
  /// @throws FileError, on all ranks, if any rank fails (no permission, disk
  /// full).
  void
  checked_write(const MPI_Comm                             communicator,
                const std::string                         &name,
                const std::function<void(std::ostream &)> &write);

  /// The same, and write_to_disk(): what a run goes on from after a power
  /// failure.
  void
  checked_write_to_disk(const MPI_Comm                             communicator,
                        const std::string                         &name,
                        const std::function<void(std::ostream &)> &write);

  /// Waits until the file or folder @p name is on the disk, so that not even a
  /// power failure takes it away: some milliseconds. @return false if that is
  /// not possible.
  bool
  write_to_disk(const std::string &name);

  /// Throws a FileError about @p name on all ranks if @p success is false on
  /// any of them.
  void
  check_written(const MPI_Comm     communicator,
                const std::string &name,
                const bool         success);
} // namespace ElastoPlastic

#endif
