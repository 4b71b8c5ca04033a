// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <type_traits>

#include "base/exceptions.h"
#include "output/checked_write.h"
#include "restart/saved_mesh.h"

namespace ElastoPlastic
{
  namespace
  {
    template <typename T>
    void
    write(std::ostream &file, const T *const data, const std::size_t n)
    {
      static_assert(std::is_trivially_copyable_v<T>);
      file.write(reinterpret_cast<const char *>(data), n * sizeof(T));
    }



    template <typename T>
    void
    read(std::istream &file, T *const data, const std::size_t n)
    {
      static_assert(std::is_trivially_copyable_v<T>);
      file.read(reinterpret_cast<char *>(data), n * sizeof(T));
    }



    std::string
    file_name(const std::string &name, const unsigned int rank)
    {
      return name + "-" + Utilities::int_to_string(rank, 4);
    }



    void
    check_read(const std::istream &file,
               const std::string  &name,
               const unsigned int  rank)
    {
      if (!file)
        throw FileError("The file '" + file_name(name, rank) +
                        "' could not be read.");
    }



    struct Header
    {
      std::uint64_t n_cells = 0, n_values = 0;
    };



    template <int dim>
    void
    write_cells(
      std::ostream                                        &file,
      const std::function<void(const CellVisitor<dim> &)> &for_each_cell)
    {
      Header                           header;
      std::vector<CellId::binary_type> ids;
      for_each_cell([&](const auto &cell, const std::vector<double> &values) {
        header = {header.n_cells + 1, values.size()};
        ids.push_back(cell->id().template to_binary<dim>());
      });
      write(file, &header, 1);
      write(file, ids.data(), ids.size());
      for_each_cell([&](const auto &cell, const std::vector<double> &values) {
        const Point<dim> centre = cell->center();
        write(file, &centre[0], dim);
        write(file, values.data(), values.size());
      });
    }



    [[noreturn]] void
    reject_mesh()
    {
      throw InputError(
        "The checkpoint holds the cells of another mesh. Has the mesh in "
        "'Geometry/File' changed? Begin anew with the option --overwrite "
        "instead of --resume.");
    }
  } // namespace



  template <int dim>
  void
  save_mesh(const MPI_Comm                                       communicator,
            const std::function<void(const CellVisitor<dim> &)> &for_each_cell,
            const std::string                                   &name)
  {
    checked_write_to_disk(
      communicator,
      file_name(name, Utilities::MPI::this_mpi_process(communicator)),
      [&](std::ostream &file) { write_cells<dim>(file, for_each_cell); });
  }



  template <int dim>
  SavedMesh<dim>::SavedMesh(const MPI_Comm     communicator,
                            const std::string &name)
    : communicator(communicator)
    , name(name)
  {
    rethrow_collectively(communicator, [&]() { read_index(); });
  }



  template <int dim>
  void
  SavedMesh<dim>::read_index()
  {
    for (unsigned int n = 0; std::filesystem::exists(file_name(name, n)); ++n)
      {
        std::ifstream file(file_name(name, n), std::ios::binary);
        Header        header;
        read(file, &header, 1);
        check_read(file, name, n);
        std::vector<CellId::binary_type> ids(header.n_cells);
        read(file, ids.data(), ids.size());
        check_read(file, name, n);
        std::uint64_t position =
          sizeof(header) + ids.size() * sizeof(CellId::binary_type);
        for (const auto &id : ids)
          {
            cells.push_back({CellId(id), n, position, header.n_values});
            position += (dim + header.n_values) * sizeof(double);
          }
      }
    std::sort(cells.begin(),
              cells.end(),
              [](const SavedCell &a, const SavedCell &b) {
                return a.id < b.id;
              });
  }



  /// The first cell that is @p id or a descendant of it.
  template <int dim>
  const typename SavedMesh<dim>::SavedCell &
  SavedMesh<dim>::find(const CellId &id) const
  {
    const auto found =
      std::lower_bound(cells.begin(),
                       cells.end(),
                       id,
                       [](const SavedCell &cell, const CellId &id) {
                         return cell.id < id;
                       });
    if (found == cells.end() ||
        (found->id != id && !id.is_ancestor_of(found->id)))
      reject_mesh();
    return *found;
  }



  /// @return whether there is a cell on this rank that is to be refined.
  template <int dim>
  bool
  SavedMesh<dim>::flag_ancestors(Triangulation<dim> &triangulation) const
  {
    bool any = false;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && find(cell->id()).id != cell->id())
        {
          cell->set_refine_flag();
          any = true;
        }
    return any;
  }



  template <int dim>
  void
  SavedMesh<dim>::refine(
    parallel::distributed::Triangulation<dim> &triangulation) const
  {
    while (true)
      {
        bool refine = false;
        rethrow_collectively(communicator,
                             [&]() { refine = flag_ancestors(triangulation); });
        if (!Utilities::MPI::logical_or(refine, communicator))
          break;
        triangulation.execute_coarsening_and_refinement();
      }
    rethrow_collectively(communicator, [&]() {
      if (triangulation.n_global_active_cells() != cells.size())
        reject_mesh();
    });
  }



  // Centres are compared, because cells of another mesh may have the same ids.
  template <int dim>
  std::vector<double>
  SavedMesh<dim>::values(
    const typename Triangulation<dim>::active_cell_iterator &cell)
  {
    const CellId     id    = cell->id();
    const SavedCell &saved = find(id);
    if (saved.file != n_of_stream)
      {
        n_of_stream = saved.file;
        stream = std::ifstream(file_name(name, n_of_stream), std::ios::binary);
      }
    std::vector<double> values(saved.n_values);
    Point<dim>          centre;
    stream.seekg(saved.position);
    read(stream, &centre[0], dim);
    read(stream, values.data(), values.size());
    check_read(stream, name, n_of_stream);
    if (centre.distance(cell->center()) > 1e-8 * cell->diameter())
      reject_mesh();
    return values;
  }



  template void
  save_mesh<2>(const MPI_Comm,
               const std::function<void(const CellVisitor<2> &)> &,
               const std::string &);
  template void
  save_mesh<3>(const MPI_Comm,
               const std::function<void(const CellVisitor<3> &)> &,
               const std::string &);
  template class SavedMesh<2>;
  template class SavedMesh<3>;
} // namespace ElastoPlastic
