// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef restart_saved_mesh_h
#define restart_saved_mesh_h

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/cell_id.h>

#include <cstdint>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace ElastoPlastic
{
  using namespace dealii;

  /// Is shown a locally owned cell and numbers that belong to it, equally many
  /// for all cells.
  template <int dim>
  using CellVisitor = std::function<
    void(const typename Triangulation<dim>::active_cell_iterator &,
         const std::vector<double> &)>;

  /// Writes cells with numbers into files whose names begin with @p name: one
  /// of each rank, which may be read by any number of ranks.
  /// (Triangulation::save() cannot be used: on a full disk, p4est aborts and
  /// MPI's shared file pointers wait for ever.)
  ///
  /// @p for_each_cell shows what it is passed all cells of this rank, always in
  /// the same order: there is room in memory for the numbers of one cell at a
  /// time.
  ///
  /// A file holds, in the representation of the machine, the number of cells
  /// and that of values of each; the CellIds; and, cell by cell, the centre and
  /// the values.
  ///
  /// Collective. @throws FileError
  template <int dim>
  void
  save_mesh(const MPI_Comm                                       communicator,
            const std::function<void(const CellVisitor<dim> &)> &for_each_cell,
            const std::string                                   &name);



  /// The files that save_mesh() has written. What this class throws on one
  /// rank alone, it throws on all, or is to be called within
  /// rethrow_collectively().
  template <int dim>
  class SavedMesh
  {
  public:
    /// Collective. @throws FileError
    SavedMesh(const MPI_Comm communicator, const std::string &name);

    /// Refines @p triangulation, which is the coarse mesh of the one saved,
    /// until it has the same cells. Collective. @throws InputError if the files
    /// hold another mesh.
    void
    refine(parallel::distributed::Triangulation<dim> &triangulation) const;

    /// The numbers of @p cell. Calls are quick in the order of the files.
    /// @throws InputError if the files hold another mesh; FileError
    std::vector<double>
    values(const typename Triangulation<dim>::active_cell_iterator &cell);

  private:
    /// Where the numbers of a cell are: centre and values.
    struct SavedCell
    {
      CellId        id;
      unsigned int  file;
      std::uint64_t position;
      std::uint64_t n_values;
    };

    void
    read_index();

    const SavedCell &
    find(const CellId &id) const;

    bool
    flag_ancestors(Triangulation<dim> &triangulation) const;

    const MPI_Comm         communicator;
    const std::string      name;
    std::vector<SavedCell> cells; ///< of all files, ordered by their ids

    /// The file that is open.
    std::ifstream stream;
    unsigned int  n_of_stream = numbers::invalid_unsigned_int;
  };
} // namespace ElastoPlastic

#endif
