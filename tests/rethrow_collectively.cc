// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

// What one rank throws, all throw: errors of the program, and what the standard
// library throws where the machine is at its limits. What none of them throws,
// none does.

#include <filesystem>
#include <new>

#include "base/exceptions.h"
#include "verdict.h"

using namespace ElastoPlastic;

namespace
{
  /// @p body runs on the last rank only.
  void
  test(const std::string &title, const std::function<void()> &body)
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const unsigned int last =
      Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
    std::string what = "nothing";
    try
      {
        rethrow_collectively(MPI_COMM_WORLD, [&]() {
          if (rank == last)
            body();
        });
      }
    catch (const Error &error)
      {
        what =
          std::to_string(static_cast<int>(error.status)) + ": " + error.what();
      }
    const auto all = Utilities::MPI::all_gather(MPI_COMM_WORLD, what);
    for (const std::string &other : all)
      if (other != what)
        what = "FAILED, the ranks disagree";
    output() << title << ": " << what << std::endl;
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  namespace fs = std::filesystem;
  test("no error", []() {});
  test("input", []() { throw InputError("There is none."); });
  test("convergence", []() { throw ConvergenceError("It diverges."); });
  test("memory", []() { throw std::bad_alloc(); });
  test("folder", []() { fs::directory_iterator("no such folder"); });
}
