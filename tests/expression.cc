// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What an expression may contain, and that it says where it must be evaluated:
// within rethrow_collectively(), if there are several ranks.

#include "base/exceptions.h"
#include "base/expression.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  double
  value_of(const std::string &text)
  {
    return Expression<1>("Entry", text).value(Point<1>(0.5));
  }



  void
  check_values()
  {
    verify("commas between arguments",
           value_of("if(t < 1, max(t, min(2, (3))), 0)") == 2. &&
             value_of("pow (t, 2) + atan2(0, (t*(t)))") == 0.25);
    verify("comparisons",
           value_of("t==0.5") == 1. && value_of("t <= 0.5") == 1. &&
             value_of("t>=0.6") == 0. && value_of("t != 0.5") == 0.);
    for (const std::string text : {"0,5",
                                   "t*(0,5)",
                                   "max(1, 2) + (1,5)",
                                   "1,",
                                   ",",
                                   "t = 1",
                                   "=t",
                                   "if(t=1, 2, 3)"})
      print_error(text, [&]() { value_of(text); });
  }



  /// On the last rank only.
  void
  fail_together(const Expression<2> &expression)
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const unsigned int last =
      Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
    rethrow_collectively(MPI_COMM_WORLD, [&]() {
      expression.value(Point<2>(rank == last ? -1. : 1., 0.));
    });
  }



  void
  check_ranks()
  {
    const Expression<2> expression("Entry", "log(x)");
    print_error("Not a number on one rank",
                [&]() { fail_together(expression); });

    bool one_rank_throws = true;
    try
      {
        expression.value(Point<2>(-1., 0.));
      }
    catch (const ExceptionBase &) // which ends the program
      {
        one_rank_throws = false;
      }
    catch (const Error &)
      {}
    const bool alone = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
    verify("one rank throws only if there are no others",
           one_rank_throws == alone);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_values();
  check_ranks();
}
