// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// The page doc/lookup/tables.md, which is the expected output of this test:
// what the columns of the tables mean is said where they are defined.

#include "output/columns.h"
#include "verdict.h"

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ElastoPlastic::print_table_reference(output(), {});
}
