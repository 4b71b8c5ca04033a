// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_exceptions_h
#define base_exceptions_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/patterns.h>

#include <exception>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace ElastoPlastic
{
  using namespace dealii;



  /// What the program returns to the shell.
  enum class ExitStatus : int
  {
    success        = 0,
    wrong_input    = 2,  ///< wrong usage, or a parameter that makes no sense
    no_convergence = 3,  ///< every remedy has been tried
    no_equilibrium = 4,  ///< no stress field can carry the load
    io_failure     = 5,  ///< a file could not be read or written
    terminated     = 143 ///< the signal SIGTERM: 128 + 15, as shells have it
  };

  /// For messages about lists that are longer than they should be.
  inline const std::string decimal_point_hint =
    "Numbers have a decimal point; a comma separates two of them.";

  /// An error a user can act on: one clear message, and the exit status that
  /// the program ends with. The message says what is wrong, where (file,
  /// section, entry, value), what is allowed, and how to mend it; it ends
  /// without a newline. Thrown with the same message on all ranks.
  class Error : public std::runtime_error
  {
  public:
    Error(const ExitStatus status, const std::string &message)
      : std::runtime_error(message)
      , status(status)
    {}

    const ExitStatus status;
  };

  /// Wrong usage or wrong input.
  struct InputError : Error
  {
    explicit InputError(const std::string &message)
      : Error(ExitStatus::wrong_input, message)
    {}

    /// The @p value of one entry is not allowed; a text, or what the entry has
    /// become. @p path is written like "Material/Yield stress"; @p remedy
    /// completes the sentence "..., but".
    template <typename Value>
    InputError(const std::string &path,
               const Value       &value,
               const std::string &remedy)
      : InputError("The entry '" + path + "' is '" + abbreviated(value) +
                   "', but " + remedy)
    {}

  private:
    /// A message is to be read.
    static std::string
    abbreviated(const std::string &value)
    {
      constexpr std::size_t longest = 500;
      return value.size() <= longest ? value : value.substr(0, longest) + "...";
    }

    template <typename Value,
              typename = std::enable_if_t<
                !std::is_convertible_v<const Value &, std::string>>>
    static std::string
    abbreviated(const Value &value)
    {
      return abbreviated(dealii::Patterns::Tools::to_string(value));
    }
  };

  /// The error that ends the program with @p exit_status.
  template <ExitStatus exit_status>
  struct ErrorOf : Error
  {
    explicit ErrorOf(const std::string &message)
      : Error(exit_status, message)
    {}
  };

  /// The iteration has not converged after every remedy.
  using ConvergenceError = ErrorOf<ExitStatus::no_convergence>;

  /// No stress field can carry the load.
  using EquilibriumError = ErrorOf<ExitStatus::no_equilibrium>;

  /// Somebody has asked the program to end.
  using TerminationError = ErrorOf<ExitStatus::terminated>;

  /// A file or directory could not be read or written.
  using FileError = ErrorOf<ExitStatus::io_failure>;

  /// What has been asked for is more than the memory that is left.
  struct MemoryError : FileError
  {
    using FileError::FileError;
  };



  /// Runs @p body, which does the rank's own part of something and may
  /// therefore fail with an Error on some ranks only. All ranks then throw what
  /// the first of these has thrown; nobody waits for a rank that has given up.
  /// Collective; @p body must not communicate.
  void
  rethrow_collectively(const MPI_Comm               communicator,
                       const std::function<void()> &body);

  /// Runs @p task on the first rank, for all. The same in all else.
  void
  on_first_rank(const MPI_Comm communicator, const std::function<void()> &task);

  /// Throws the kind of Error that ends the program with @p status.
  [[noreturn]] void
  throw_error(const ExitStatus status, const std::string &message);

  /// Whether an Error of this rank alone leaves nobody waiting: within
  /// rethrow_collectively(), and where there are no other ranks.
  bool
  may_throw_alone();



  /// What a user is told where the machine is at its limits, which the standard
  /// library says by exceptions of its own: no memory, or a file or folder that
  /// cannot be used. Nothing for any other exception, which is a bug.
  std::optional<FileError>
  machine_error(const std::exception &exception);
} // namespace ElastoPlastic

#endif
