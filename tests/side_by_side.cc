// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// Two functions that run at the same time: they share the threads, what they do
// in turn is done by one of them only, and one without enough memory is called
// again. These tests would wait for ever if they did not run at the same time.

#include <deal.II/base/mpi.h>

#include <future>
#include <string>

#include "base/exceptions.h"
#include "bounds/conic/side_by_side.h"
#include "verdict.h"

#include <omp.h>

using namespace ElastoPlastic;

namespace
{
  int
  share_of_threads()
  {
    const SharedThreads::Share share;
    return omp_get_max_threads();
  }



  void
  test_threads()
  {
    omp_set_num_threads(4);
    verify("alone, before", share_of_threads() == 4);
    std::promise<void> second_runs, first_has_seen;
    int                beside = 0, of_second = 0;
    call_side_by_side(
      [&]() {
        const ExclusiveWork::Pause pause;
        second_runs.get_future().wait();
        beside = share_of_threads();
        first_has_seen.set_value();
        while (share_of_threads() != 4)
          ; // until the second has ended
      },
      [&]() {
        const ExclusiveWork::Pause pause;
        second_runs.set_value();
        first_has_seen.get_future().wait();
        of_second = share_of_threads();
      });
    verify("half of the threads for each", beside == 2 && of_second == 2);
    verify("all remain", omp_get_max_threads() == 4);
  }



  // The second one begins when the first pauses.
  void
  test_turns()
  {
    std::string        turns;
    std::promise<void> second_has_begun;
    call_side_by_side(
      [&]() {
        turns += "1";
        {
          const ExclusiveWork::Pause pause;
          second_has_begun.get_future().wait();
        }
        turns += "1";
      },
      [&]() {
        turns += "2";
        second_has_begun.set_value();
        turns += "2";
      });
    verify("in turn", turns == "1221");
  }



  void
  test_memory()
  {
    std::string calls;
    call_side_by_side([&]() { calls += "1"; },
                      [&]() {
                        calls += "2";
                        if (calls == "12")
                          throw MemoryError("too much beside the first");
                      });
    verify("the second once more", calls == "122");
    calls.clear();
    try
      {
        call_side_by_side(
          [&]() {
            calls += "1";
            throw MemoryError("of the first");
          },
          [&]() {
            calls += "2";
            throw MemoryError("of the second");
          });
      }
    catch (const MemoryError &error)
      {
        verify("the error of the first",
               calls == "12" && error.what() == std::string("of the first"));
      }
    calls.clear();
    try
      {
        call_side_by_side([&]() { calls += "1"; },
                          [&]() {
                            calls += "2";
                            throw MemoryError("too much in any case");
                          });
      }
    catch (const MemoryError &)
      {
        verify("too much in any case", calls == "122");
      }
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_threads();
  test_turns();
  test_memory();
}
