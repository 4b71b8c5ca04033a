// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <csignal>

#include "base/termination.h"

namespace ElastoPlastic
{
  namespace
  {
    // A signal handler may do no more than set such a variable.
    volatile std::sig_atomic_t signal_received = 0;
  } // namespace



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
