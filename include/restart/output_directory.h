// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef restart_output_directory_h
#define restart_output_directory_h

#include <boost/interprocess/sync/file_lock.hpp>

#include <functional>
#include <string>

#include <mpi.h>

namespace ElastoPlastic
{
  /// The folder that receives the results of a run. While this object lives, no
  /// other run can use the folder: the first rank holds a lock on its file
  /// ".lock", which the system takes away from a process that is killed. (On
  /// the few file systems that know no locks there is none.)
  ///
  /// Earlier results that are to be replaced are set aside, in the folder
  /// ".earlier_results" beside the new ones, until there is a first complete
  /// new result. If the run ends before that, they come back: at once, or, if
  /// it has been killed, when the folder is used the next time. Nothing but
  /// what the program itself has written is ever moved or removed.
  ///
  /// Collective are the functions, not constructor and destructor.
  class OutputDirectory
  {
  public:
    /// Touches nothing yet.
    OutputDirectory(const MPI_Comm communicator, const std::string &name)
      : communicator(communicator)
      , name(name)
    {}


    OutputDirectory(const OutputDirectory &) = delete;

    /// Brings earlier results back if they are still set aside.
    ~OutputDirectory();

    /// Whether there are results in the folder, or set aside there.
    /// @throws FileError if something stands in their way.
    bool
    holds_results() const;

    /// Makes the folder ready for a new run: creates it, and refuses to touch
    /// earlier results, or sets them aside if @p overwrite. The @p
    /// effective_input goes into the file parameters.prm.
    /// @throws InputError if there are results already; FileError if the folder
    /// is in use, or cannot be created or written to.
    void
    begin_run(const bool overwrite, const std::string &effective_input);

    /// The same for a run that goes on with what is there, if there is a folder
    /// at all. @throws FileError
    void
    resume_run();

    /// Writes the file parameters.prm. @throws FileError
    void
    write_input(const std::string &effective_input) const;

    /// There is a first complete result: what has been set aside is removed.
    /// @throws FileError
    void
    accept_results();

  private:
    void
    on_first_rank(const std::function<void()> &task) const;

    void
    lock();

    const MPI_Comm                 communicator;
    const std::string              name;
    boost::interprocess::file_lock file_lock;
    bool                           earlier_results_are_aside = false;
  };
} // namespace ElastoPlastic

#endif
