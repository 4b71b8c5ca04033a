// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <filesystem>
#include <new>
#include <string>

#include "base/exceptions.h"

namespace ElastoPlastic
{
  namespace
  {
    /// How many calls of rethrow_collectively() this rank is within.
    unsigned int depth = 0;

    class Scope
    {
    public:
      Scope()
      {
        ++depth;
      }

      ~Scope()
      {
        --depth;
      }

      Scope(const Scope &) = delete;
    };
  } // namespace



  void
  throw_error(const ExitStatus status, const std::string &message)
  {
    switch (status)
      {
        case ExitStatus::wrong_input:
          throw InputError(message);
        case ExitStatus::no_convergence:
          throw ConvergenceError(message);
        case ExitStatus::no_equilibrium:
          throw EquilibriumError(message);
        case ExitStatus::io_failure:
          throw FileError(message);
        case ExitStatus::terminated:
          throw TerminationError(message);
        default:
          throw Error(status, message);
      }
  }



  void
  rethrow_collectively(const MPI_Comm               communicator,
                       const std::function<void()> &body)
  {
    std::string error;
    int         status = 0;
    try
      {
        const Scope scope;
        body();
      }
    catch (const Error &exception)
      {
        error  = exception.what();
        status = static_cast<int>(exception.status);
      }
    catch (const std::exception &exception)
      {
        const auto known = machine_error(exception);
        if (!known)
          throw;
        error  = known->what();
        status = static_cast<int>(known->status);
      }
    const unsigned int rank   = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int nobody = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int first =
      Utilities::MPI::min(error.empty() ? nobody : rank, communicator);
    if (first != nobody)
      {
        status = Utilities::MPI::broadcast(communicator, status, first);
        throw_error(static_cast<ExitStatus>(status),
                    Utilities::MPI::broadcast(communicator, error, first));
      }
  }



  void
  on_first_rank(const MPI_Comm communicator, const std::function<void()> &task)
  {
    rethrow_collectively(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        task();
    });
  }



  bool
  may_throw_alone()
  {
    return depth > 0 || Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
  }



  std::optional<FileError>
  machine_error(const std::exception &exception)
  {
    if (dynamic_cast<const std::bad_alloc *>(&exception))
      return FileError(
        "there is not enough memory. Choose a coarser mesh, or "
        "more processes on more machines.");
    if (dynamic_cast<const std::filesystem::filesystem_error *>(&exception))
      return FileError(std::string("a file or folder cannot be used: ") +
                       exception.what());
    return {};
  }
} // namespace ElastoPlastic
