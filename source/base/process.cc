// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <atomic>
#include <csignal>
#include <iomanip>
#include <sstream>

#include "base/exceptions.h"
#include "base/process.h"

#ifdef __GLIBC__
#  include <malloc.h>
#endif
#include <unistd.h>

namespace ElastoPlastic
{
  namespace
  {
    /// The memory of this machine, in bytes.
    double
    physical_memory()
    {
      return static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
             static_cast<double>(sysconf(_SC_PAGE_SIZE));
    }



    std::atomic<double> reserved_bytes = 0;



    void
    add_to(std::atomic<double> &sum, const double value)
    {
      double before = sum;
      while (!sum.compare_exchange_weak(before, before + value))
        ;
    }



    /// By this process, in bytes; also what has been reserved.
    double
    memory_in_use()
    {
      dealii::Utilities::System::MemoryStats stats;
      dealii::Utilities::System::get_memory_stats(stats);
      return 1024. * stats.VmRSS + reserved_bytes;
    }



    // A signal handler may do no more than set such a variable.
    volatile std::sig_atomic_t signal_received = 0;
  } // namespace



  double
  peak_memory(const MPI_Comm communicator)
  {
    dealii::Utilities::System::MemoryStats stats;
    dealii::Utilities::System::get_memory_stats(stats);
    return dealii::Utilities::MPI::sum(stats.VmHWM / 1024., communicator);
  }



  double
  machine_memory(const MPI_Comm communicator)
  {
    MPI_Comm machine;
    MPI_Comm_split_type(
      communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    const double share =
      physical_memory() / dealii::Utilities::MPI::n_mpi_processes(machine);
    MPI_Comm_free(&machine);
    return dealii::Utilities::MPI::sum(share, communicator);
  }



  void
  require_memory(const double bytes, const std::string &purpose)
  {
    constexpr double gigabyte = 1e9;

    const double all  = physical_memory();
    double       used = memory_in_use();
    if (bytes > all - used)
      {
        return_free_memory();
        used = memory_in_use();
      }
    if (bytes <= all - used)
      return;
    std::ostringstream message;
    message << std::setprecision(2) << "there is not enough memory " << purpose
            << ": that takes about " << bytes / gigabyte
            << " GB, and of the machine's " << all / gigabyte
            << " GB this process holds " << used / gigabyte
            << " already. Choose a coarser mesh ('Geometry/Initial "
               "refinements'), or fewer of them ('Refinement/Number of "
               "cycles').";
    throw MemoryError(message.str());
  }



  ReservedMemory::ReservedMemory(const double bytes)
    : bytes(bytes)
  {
    add_to(reserved_bytes, bytes);
  }



  ReservedMemory::~ReservedMemory()
  {
    add_to(reserved_bytes, -bytes);
  }



  void
  return_free_memory()
  {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  }



  void
  return_large_blocks()
  {
#ifdef __GLIBC__
    constexpr int most_blocks = 65536, smallest_block = 32 << 20;
    mallopt(M_MMAP_MAX, most_blocks);
    mallopt(M_MMAP_THRESHOLD, smallest_block);
#endif
  }



  void
  note_termination_requests()
  {
    std::signal(SIGTERM, [](int) { signal_received = 1; });
  }



  bool
  termination_requested_here()
  {
    return signal_received != 0;
  }



  bool
  termination_requested(const MPI_Comm communicator)
  {
    return dealii::Utilities::MPI::logical_or(termination_requested_here(),
                                              communicator);
  }
} // namespace ElastoPlastic
