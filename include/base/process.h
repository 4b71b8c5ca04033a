// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_process_h
#define base_process_h

#include <iostream>
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
  /// which this process holds some already, or has reserved it. Linux promises
  /// more than there is, and ends processes that use it.
  /// @param purpose says what for, in a clause like "to factorise a matrix".
  /// @throws MemoryError if the @p bytes do not fit.
  void
  require_memory(const double bytes, const std::string &purpose);



  /// While it lives, require_memory() counts these bytes as used: those of
  /// something that asks for memory again and again, and gives it back, maybe
  /// at the same time as others.
  class ReservedMemory
  {
  public:
    explicit ReservedMemory(const double bytes);
    ~ReservedMemory();

    ReservedMemory(const ReservedMemory &) = delete;
    ReservedMemory &
    operator=(const ReservedMemory &) = delete;

  private:
    const double bytes;
  };



  /// Gives memory that is not used back to the system, as far as the C library
  /// can do that: it keeps what has been freed in pieces.
  void
  return_free_memory();

  /// From now on, blocks of 32 MB and more go back to the system when they are
  /// freed, so that they leave no holes in the memory of the process; smaller
  /// ones stay. GNU's C library would give back both, but SuperLU_DIST, which
  /// deal.II brings along, forbids it.
  void
  return_large_blocks();



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



  /// As long as it lives, keeps what is sent to std::cerr from the user: what
  /// libraries print there, on every rank, before they report an error.
  class SilentErrorStream
  {
  public:
    SilentErrorStream()
      : buffer(std::cerr.rdbuf(nullptr))
    {}

    ~SilentErrorStream()
    {
      std::cerr.rdbuf(buffer); // clears the state, too
    }

    SilentErrorStream(const SilentErrorStream &) = delete;
    SilentErrorStream &
    operator=(const SilentErrorStream &) = delete;

  private:
    std::streambuf *const buffer;
  };
} // namespace ElastoPlastic

#endif
