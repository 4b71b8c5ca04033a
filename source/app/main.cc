// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include "app/program.h"

int
main(int argc, char *argv[])
{
  // (PETSc, which deal.II starts too where it has it, would take our options
  // for its own, and complain of those it does not know.)
  int                                            only_name = 1;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(only_name, argv, 1);
  return ElastoPlastic::run_program(argc, argv);
}
