// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <cstdlib>

#include "app/program.h"

namespace
{
  /// A process that is alone needs no network, and nobody who starts others:
  /// what Open MPI 4 loads for these takes longer than many a run. (What a user
  /// has chosen stays.)
  void
  leave_out_network_if_alone()
  {
    for (const char *of_launcher :
         {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
      if (std::getenv(of_launcher))
        return;
    setenv("OMPI_MCA_btl", "^tcp,ofi", /* overwrite = */ 0);
    setenv("OMPI_MCA_ess_singleton_isolated", "1", /* overwrite = */ 0);
  }
} // namespace



int
main(int argc, char *argv[])
{
  leave_out_network_if_alone();
  // (PETSc, which deal.II starts too where it has it, would take our options
  // for its own, and complain of those it does not know.)
  int                                            only_name = 1;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(only_name, argv, 1);
  return ElastoPlastic::run_program(argc, argv);
}
