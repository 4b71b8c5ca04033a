// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// More memory than the machine has is refused before it is asked for; large
// blocks go back to the system when they are freed.

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <vector>

#include "base/process.h"
#include "verdict.h"

#ifdef __GLIBC__
#  include <malloc.h>
#endif

using namespace dealii;
using namespace ElastoPlastic;

namespace
{
  /// Resident bytes of this process when @p n_bytes have been freed, while a
  /// little that came after them has not.
  double
  memory_after(const std::size_t n_bytes)
  {
    std::vector<char>       large(n_bytes, 1);
    const std::vector<char> behind(100000, 1);
    large = std::vector<char>();
    Utilities::System::MemoryStats stats;
    Utilities::System::get_memory_stats(stats);
    return 1024. * stats.VmRSS;
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  require_memory(1e6, "for little");
  {
    const ReservedMemory reserved(1e18);
    try
      {
        require_memory(1e6, "for little");
        output() << "FAILED: beside a billion gigabytes" << std::endl;
      }
    catch (const MemoryError &)
      {
        output() << "Reserved" << std::endl;
      }
  }
  require_memory(1e6, "for little");
  return_free_memory();

#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0); // as SuperLU_DIST does
  mallopt(M_TRIM_THRESHOLD, -1);
#endif
  return_large_blocks();
  const double before = memory_after(1);
  verify("large blocks go back", memory_after(128 << 20) - before, 32e6);

  try
    {
      require_memory(1e18, "to factorise a matrix");
      output() << "FAILED: a billion gigabytes" << std::endl;
    }
  catch (const FileError &error)
    {
      const std::string begin =
        "there is not enough memory to factorise a matrix: that takes about "
        "1e+09 GB, and of the machine's ";
      verify("message", std::string(error.what()).rfind(begin, 0) == 0);
      verify("exit status", error.status == ExitStatus::io_failure);
    }
}
