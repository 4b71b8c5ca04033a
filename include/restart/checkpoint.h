// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef restart_checkpoint_h
#define restart_checkpoint_h

#include <functional>
#include <map>
#include <string>

#include "loading/loading_parameters.h"

#include <mpi.h>

namespace ElastoPlastic
{
  /// Whether the program has written @p folder as a checkpoint, complete or
  /// not.
  bool
  is_checkpoint(const std::string &folder);



  /// The folder "checkpoint" in an output directory: everything that is needed
  /// to go on from the end of a load step. It holds the mesh with the values in
  /// its cells (a file mesh-* of each rank, see save_mesh()), the rest of the
  /// state (state), and a list of these files with sizes and checksums (index).
  ///
  /// A checkpoint is written in a folder beside the last one and renamed into
  /// its place when it is complete and on the disk, so that there is a complete
  /// one at any moment after the first.
  ///
  /// All ranks call all functions. Errors are thrown on all ranks.
  class Checkpoint
  {
  public:
    /// The entries of a parameter file: paths like "Material/Law" and values.
    using Entries = std::map<std::string, std::string>;

    /// What load() finds: the state, where the mesh is, and the entries of the
    /// run that has written it.
    struct Contents
    {
      std::string state;
      std::string mesh_file;
      Entries     entries;

      /// The section "Loading" of these entries.
      LoadingParameters
      loading() const;
    };

    /// @p entries are those of the present run.
    Checkpoint(const MPI_Comm     communicator,
               const std::string &output_directory,
               const Entries     &entries)
      : communicator(communicator)
      , directory(output_directory + "/checkpoint")
      , entries(entries)
    {}


    /// Replaces the last checkpoint. @p save_mesh writes the mesh into files
    /// whose names begin with the one it is passed; @p state is what the first
    /// rank says.
    /// @throws FileError
    void
    save(const std::string                              &state,
         const std::function<void(const std::string &)> &save_mesh) const;

    /// Finds the last complete checkpoint and checks it: that it is undamaged,
    /// written by this version of the program, and for the same problem. (The
    /// load history is for the caller to compare.)
    /// @throws InputError
    Contents
    load() const;

  private:
    void
    check_entries(const Entries &saved) const;

    const MPI_Comm    communicator;
    const std::string directory;
    const Entries     entries;
  };
} // namespace ElastoPlastic

#endif
