// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <string>

#include "base/exceptions.h"
#include "base/throw_together.h"

namespace ElastoPlastic
{
  void
  throw_together(const MPI_Comm communicator, const std::function<void()> &body)
  {
    std::string error;
    try
      {
        body();
      }
    catch (const InputError &exception)
      {
        error = exception.what();
      }
    const unsigned int rank   = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int nobody = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int first =
      Utilities::MPI::min(error.empty() ? nobody : rank, communicator);
    if (first != nobody)
      throw InputError(Utilities::MPI::broadcast(communicator, error, first));
  }
} // namespace ElastoPlastic
