// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_rethrow_collectively_h
#define base_rethrow_collectively_h

#include <deal.II/base/mpi.h>

#include <exception>
#include <functional>
#include <optional>

#include "base/exceptions.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// Runs @p body, which does the rank's own part of something and may
  /// therefore fail with an Error on some ranks only. All ranks then throw what
  /// the first of these has thrown; nobody waits for a rank that has given up.
  /// Collective; @p body must not communicate.
  void
  rethrow_collectively(const MPI_Comm               communicator,
                       const std::function<void()> &body);

  /// Runs @p task on the first rank, for all. The same in all else.
  void
  on_first_rank(const MPI_Comm communicator, const std::function<void()> &task);

  /// Throws the kind of Error that ends the program with @p status.
  [[noreturn]] void
  throw_error(const ExitStatus status, const std::string &message);

  /// Whether an Error of this rank alone leaves nobody waiting: within
  /// rethrow_collectively(), and where there are no other ranks.
  bool
  may_throw_alone();



  /// What a user is told where the machine is at its limits, which the standard
  /// library says by exceptions of its own: no memory, or a file or folder that
  /// cannot be used. Nothing for any other exception, which is a bug.
  std::optional<FileError>
  machine_error(const std::exception &exception);
} // namespace ElastoPlastic

#endif
