// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>
#include <deal.II/grid/cell_id.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <type_traits>

#include "base/exceptions.h"
#include "base/rethrow_collectively.h"
#include "io/checked_write.h"
#include "io/saved_mesh.h"

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



    std::string
    file_name(const std::string &name, const unsigned int rank)
    {
      return name + "-" + Utilities::int_to_string(rank, 4);
    }



    /// A file for reading. @throws FileError, on this rank
    class File
    {
    public:
      explicit File(const std::string &name)
        : name(name)
        , stream(name, std::ios::binary)
      {}

      template <typename T>
      void
      read(T *const data, const std::size_t n)
      {
        static_assert(std::is_trivially_copyable_v<T>);
        stream.read(reinterpret_cast<char *>(data), n * sizeof(T));
        if (!stream)
          throw FileError("The file '" + name + "' could not be read.");
      }

      void
      go_to(const std::size_t position)
      {
        stream.seekg(position);
      }

    private:
      const std::string name;
      std::ifstream     stream;
    };



    struct Header
    {
      std::uint64_t n_cells = 0, n_values = 0;
    };



    /// Where the numbers of a cell are: centre and values.
    struct SavedCell
    {
      CellId        id;
      unsigned int  file;
      std::uint64_t position;
      std::uint64_t n_values;
    };



    template <int dim>
    void
    write_cells(std::ostream             &file,
                const Triangulation<dim> &triangulation,
                const CellValues         &values)
    {
      Header                           header;
      std::vector<CellId::binary_type> ids;
      std::vector<double>              numbers;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const auto &of_cell = values[cell->active_cell_index()];
            const auto  centre  = cell->center();
            header              = {header.n_cells + 1, of_cell.size()};
            ids.push_back(cell->id().template to_binary<dim>());
            for (unsigned int d = 0; d < dim; ++d)
              numbers.push_back(centre[d]);
            numbers.insert(numbers.end(), of_cell.begin(), of_cell.end());
          }
      write(file, &header, 1);
      write(file, ids.data(), ids.size());
      write(file, numbers.data(), numbers.size());
    }



    /// All cells in all files, ordered by their ids.
    template <int dim>
    std::vector<SavedCell>
    read_cells(const std::string &name)
    {
      std::vector<SavedCell> cells;
      for (unsigned int n = 0; std::filesystem::exists(file_name(name, n)); ++n)
        {
          File   file(file_name(name, n));
          Header header;
          file.read(&header, 1);
          std::vector<CellId::binary_type> ids(header.n_cells);
          file.read(ids.data(), ids.size());
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
      return cells;
    }



    [[noreturn]] void
    reject_mesh()
    {
      throw InputError(
        "The checkpoint holds the cells of another mesh. Has the mesh in "
        "'Geometry/File' changed? Begin anew with the option --overwrite "
        "instead of --resume.");
    }



    /// The first of @p cells that is @p id or a descendant of it.
    const SavedCell &
    find(const std::vector<SavedCell> &cells, const CellId &id)
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
    flag_ancestors(Triangulation<dim>           &triangulation,
                   const std::vector<SavedCell> &cells)
    {
      bool any = false;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() &&
            find(cells, cell->id()).id != cell->id())
          {
            cell->set_refine_flag();
            any = true;
          }
      return any;
    }



    /// Centres are compared, because cells of another mesh may have the same
    /// ids.
    template <int dim>
    CellValues
    read_values(const Triangulation<dim>     &triangulation,
                const std::vector<SavedCell> &cells,
                const std::string            &name)
    {
      using Cell = typename Triangulation<dim>::active_cell_iterator;
      std::vector<std::vector<std::pair<const SavedCell *, Cell>>> in_file;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const SavedCell &saved = find(cells, cell->id());
            in_file.resize(
              std::max<std::size_t>(in_file.size(), saved.file + 1));
            in_file[saved.file].emplace_back(&saved, cell);
          }

      CellValues values(triangulation.n_active_cells());
      for (unsigned int n = 0; n < in_file.size(); ++n)
        {
          File file(file_name(name, n));
          for (const auto &[saved, cell] : in_file[n])
            {
              auto &of_cell = values[cell->active_cell_index()];
              of_cell.resize(saved->n_values);
              Point<dim> centre;
              file.go_to(saved->position);
              file.read(centre.begin_raw(), dim);
              file.read(of_cell.data(), of_cell.size());
              if (centre.distance(cell->center()) > 1e-8 * cell->diameter())
                reject_mesh();
            }
        }
      return values;
    }



    template <int dim>
    CellValues
    refine_and_read(parallel::distributed::Triangulation<dim> &triangulation,
                    const std::string                         &name)
    {
      const MPI_Comm         communicator = triangulation.get_communicator();
      std::vector<SavedCell> cells;
      rethrow_collectively(communicator,
                           [&]() { cells = read_cells<dim>(name); });

      while (true)
        {
          bool refine = false;
          rethrow_collectively(communicator, [&]() {
            refine = flag_ancestors<dim>(triangulation, cells);
          });
          if (!Utilities::MPI::logical_or(refine, communicator))
            break;
          triangulation.execute_coarsening_and_refinement();
        }

      CellValues values;
      rethrow_collectively(communicator, [&]() {
        if (triangulation.n_global_active_cells() != cells.size())
          reject_mesh();
        values = read_values<dim>(triangulation, cells, name);
      });
      return values;
    }
  } // namespace



  template <int dim>
  void
  save_mesh(const parallel::distributed::Triangulation<dim> &triangulation,
            const CellValues                                &values,
            const std::string                               &name)
  {
    const MPI_Comm communicator = triangulation.get_communicator();
    checked_write(communicator,
                  file_name(name,
                            Utilities::MPI::this_mpi_process(communicator)),
                  [&](std::ostream &file) {
                    write_cells<dim>(file, triangulation, values);
                  });
  }



  template <int dim>
  CellValues
  load_mesh(parallel::distributed::Triangulation<dim> &triangulation,
            const std::string                         &name)
  {
    return refine_and_read<dim>(triangulation, name);
  }



  template <int dim>
  void
  append_fields(CellValues                      &values,
                const std::vector<VectorType *> &fields,
                const DoFHandler<dim>           &dof_handler)
  {
    const GhostedCopies<dim>             copies(fields, dof_handler);
    std::vector<types::global_dof_index> dofs(
      dof_handler.get_fe().n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          for (const VectorType *field : copies.pointers())
            for (const auto dof : dofs)
              values[cell->active_cell_index()].push_back((*field)(dof));
        }
  }



  template <int dim>
  void
  take_fields(CellValues                      &values,
              const std::vector<VectorType *> &fields,
              const DoFHandler<dim>           &dof_handler)
  {
    std::vector<types::global_dof_index> dofs(
      dof_handler.get_fe().n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          auto      &of_cell = values[cell->active_cell_index()];
          const auto n_left  = of_cell.size() - fields.size() * dofs.size();
          auto       value   = of_cell.begin() + n_left;
          for (VectorType *field : fields)
            for (const auto dof : dofs)
              {
                if (field->in_local_range(dof))
                  (*field)(dof) = *value;
                ++value;
              }
          of_cell.resize(n_left);
        }
  }



  template void
  save_mesh(const parallel::distributed::Triangulation<2> &,
            const CellValues &,
            const std::string &);
  template CellValues
  load_mesh(parallel::distributed::Triangulation<2> &, const std::string &);
  template void
  append_fields(CellValues &,
                const std::vector<VectorType *> &,
                const DoFHandler<2> &);
  template void
  take_fields(CellValues &,
              const std::vector<VectorType *> &,
              const DoFHandler<2> &);
  template void
  save_mesh(const parallel::distributed::Triangulation<3> &,
            const CellValues &,
            const std::string &);
  template CellValues
  load_mesh(parallel::distributed::Triangulation<3> &, const std::string &);
  template void
  append_fields(CellValues &,
                const std::vector<VectorType *> &,
                const DoFHandler<3> &);
  template void
  take_fields(CellValues &,
              const std::vector<VectorType *> &,
              const DoFHandler<3> &);
} // namespace ElastoPlastic
