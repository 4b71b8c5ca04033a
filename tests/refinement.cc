// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// How many unknowns a mesh may have: as many as the user allows, and never more
// than indices of 32 bits can number.

#include "adaptivity/refinement.h"
#include "verdict.h"

using namespace ElastoPlastic;

int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  RefinementParameters parameters;
  parameters.check_first_mesh(1.9e9);
  verify("no limit of the user", parameters.allows(1.9e9));
  verify("2^31", !parameters.allows(2147483648.));
  verify("what 2^32 would wrap to 1", !parameters.allows(4294967297.));
  print_error("first mesh",
              [&]() { parameters.check_first_mesh(2147483648.); });

  parameters.max_unknowns = 1000;
  parameters.check_first_mesh(1000);
  verify("within the limit", parameters.allows(1000));
  verify("beyond the limit", !parameters.allows(1001));
  print_error("first mesh", [&]() { parameters.check_first_mesh(1001); });
  print_error("first mesh", [&]() { parameters.check_first_mesh(3e9); });
}
