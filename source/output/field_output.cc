// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/compatibility.h"
#include "contact/contact_nodes.h"
#include "evaluation/surface_fields.h"
#include "mesh/boundary_faces.h"
#include "output/body_output.h"
#include "output/checked_write.h"
#include "output/field_output.h"
#include "output/patches.h"

namespace ElastoPlastic
{
  namespace
  {
    DataOutBase::VtkFlags
    flags_with_units(const Units &units)
    {
      DataOutBase::VtkFlags flags;
      for (const std::string field : {"displacement", "gap", "slip"})
        if (!units.length.empty())
          flags.physical_units[field] = units.of("length");
      for (const std::string field : {"contact_pressure", "contact_shear"})
        if (units.are_named())
          flags.physical_units[field] = units.of("stress");
      return flags;
    }



    /// A field in the layout of displacements, with ghost values: all of its
    /// components, or only the vertical one, the last.
    struct NodalField
    {
      std::string       name;
      unsigned int      n_components; ///< dim or 1
      const VectorType &values;
    };



    /// The faces of @p boundaries at cells of this rank, with the values that
    /// @p fields have at their nodes.
    template <int dim>
    Patches<dim - 1, dim>
    boundary_patches(const DoFHandler<dim>              &dof_handler,
                     const std::set<types::boundary_id> &boundaries,
                     const std::vector<NodalField>      &fields)
    {
      const FiniteElement<dim> &fe    = dof_handler.get_fe();
      const auto                nodes = lattice_of_face(fe);
      std::vector<typename Patches<dim - 1, dim>::Field> names;
      for (const NodalField &field : fields)
        names.push_back({field.name, field.n_components});

      Patches<dim - 1, dim>                result(names);
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_face());
      for (const auto &[cell, f] : owned_faces(dof_handler, boundaries))
        {
          const auto                            face = cell->face(f);
          typename Patches<dim - 1, dim>::Patch patch;
          for (const unsigned int v : face->vertex_indices())
            patch.vertices[v] = face->vertex(v);
          patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
          patch.n_subdivisions = fe.degree;
          patch.data.reinit(result.n_components(), nodes.size());
          face->get_dof_indices(dofs);
          unsigned int row = 0;
          for (const auto &[name, n_components, values] : fields)
            for (unsigned int c = dim - n_components; c < dim; ++c, ++row)
              for (unsigned int i = 0; i < nodes.size(); ++i)
                patch.data(row, i) = values(dofs[nodes[i][c]]);
          result.add(std::move(patch));
        }
      return result;
    }
  } // namespace



  template <int dim>
  void
  FieldOutput<dim>::write(const Solution    &solution,
                          const std::string &name,
                          const double       time)
  {
    write_body(solution, name, time);
    if (!solution.contact_boundaries.empty())
      write_surface(solution, name, time);
  }



  template <int dim>
  void
  FieldOutput<dim>::write_body(const Solution    &solution,
                               const std::string &name,
                               const double       time)
  {
    const BodyOutput<dim> output(solution.dof_handler,
                                 solution.displacement,
                                 solution.solid,
                                 solution.error_indicators,
                                 parameters);
    write_files(
      output, communicator_of(solution.dof_handler), "solution", name, time);
  }



  template <int dim>
  void
  FieldOutput<dim>::write_surface(const Solution    &solution,
                                  const std::string &name,
                                  const double       time)
  {
    const SurfaceFields     values = surface_fields(solution.dof_handler,
                                                solution.constraints,
                                                solution.contact,
                                                solution.displacement,
                                                solution.residual);
    std::vector<NodalField> fields = {{"displacement",
                                       dim,
                                       values.displacement},
                                      {"gap", 1, values.gap},
                                      {"contact_pressure", 1, values.pressure},
                                      {"active", 1, values.active}};

    VectorType slip;
    if (solution.contact.has_friction())
      {
        slip = solution.slip;
        solution.constraints.distribute(slip);
        replace_by_ghosted_copy(slip, solution.dof_handler);
        fields.push_back({"contact_shear", dim, values.shear});
        fields.push_back({"slip", dim, slip});
        fields.push_back({"stick", 1, values.stick});
      }

    auto output = boundary_patches(solution.dof_handler,
                                   solution.contact_boundaries,
                                   fields);
    output.set_flags(flags_with_units(parameters.units));
    write_files(
      output, communicator_of(solution.dof_handler), "surface", name, time);
  }



  template <int dim>
  template <typename Output>
  void
  FieldOutput<dim>::write_files(const Output      &output,
                                const MPI_Comm     communicator,
                                const std::string &kind,
                                const std::string &name,
                                const double       time)
  {
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const std::string  stem    = kind + "-" + name;
    const auto         piece   = [&](const unsigned int r) {
      return stem + "." + Utilities::int_to_string(r, 4) + ".vtu";
    };
    write_file(communicator,
               output.empty() ? "" : piece(rank),
               [&](std::ostream &file) { output.write_vtu(file); });

    // ParaView does not like empty pieces.
    const auto is_empty =
      Utilities::MPI::all_gather(communicator, int(output.empty()));
    std::vector<std::string> pieces;
    for (unsigned int r = 0; r < n_ranks; ++r)
      if (!is_empty[r])
        pieces.push_back(piece(r));
    const bool first_rank = (rank == 0);
    write_file(communicator,
               first_rank ? stem + ".pvtu" : "",
               [&](std::ostream &file) {
                 output.write_pvtu_record(file, pieces);
               });

    auto &record = records[kind];
    if (!record.empty() && record.back().second == stem + ".pvtu")
      record.pop_back();
    record.emplace_back(time, stem + ".pvtu");
    write_file(communicator,
               first_rank ? kind + ".pvd" : "",
               [&](std::ostream &file) {
                 DataOutBase::write_pvd_record(file, record);
               });
  }



  template <int dim>
  void
  FieldOutput<dim>::write_file(const MPI_Comm     communicator,
                               const std::string &name,
                               const std::function<void(std::ostream &)> &write)
  {
    const std::string path =
      name.empty() ? "" : parameters.directory + "/" + name;
    checked_write(communicator, path, write);
    if (!path.empty())
      written.insert(path);
  }



  // With the first that fails, those after it are not tried. What the user has
  // removed meanwhile is not missed. (Nothing is thrown on a single rank.)
  template <int dim>
  void
  FieldOutput<dim>::write_to_disk(const MPI_Comm communicator)
  {
    const auto failed =
      std::find_if(written.begin(), written.end(), [](const std::string &file) {
        std::error_code ignored;
        return std::filesystem::status(file, ignored).type() !=
                 std::filesystem::file_type::not_found &&
               !ElastoPlastic::write_to_disk(file);
      });
    check_written(communicator,
                  failed == written.end() ? "" : *failed,
                  failed == written.end());
    written.clear();
  }



  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace ElastoPlastic
