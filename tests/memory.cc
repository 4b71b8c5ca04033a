// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// More memory than the machine has is refused before it is asked for.

#include <deal.II/base/mpi.h>

#include "base/process.h"
#include "verdict.h"

using namespace dealii;
using namespace ElastoPlastic;

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
