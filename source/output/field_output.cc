// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/compatibility.h"
#include "evaluation/surface_fields.h"
#include "output/body_output.h"
#include "output/boundary_patches.h"
#include "output/checked_write.h"
#include "output/field_output.h"

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
  } // namespace



  template <int dim>
  FieldOutput<dim>::FieldOutput(const OutputParameters &parameters)
    : parameters(parameters)
  {}



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



  // With the first that fails, those after it are not tried.
  template <int dim>
  void
  FieldOutput<dim>::write_to_disk(const MPI_Comm communicator)
  {
    const auto failed = std::find_if_not(written.begin(),
                                         written.end(),
                                         ElastoPlastic::write_to_disk);
    check_written(communicator,
                  failed == written.end() ? "" : *failed,
                  failed == written.end());
    written.clear();
  }



  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace ElastoPlastic
