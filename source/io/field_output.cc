// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/numerics/data_out_faces.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <cmath>
#include <fstream>

#include "evaluation/surface_fields.h"
#include "io/body_output.h"
#include "io/checked_write.h"
#include "io/field_output.h"

namespace ElastoPlastic
{
  namespace
  {
    using Interpretation =
      DataComponentInterpretation::DataComponentInterpretation;

    /// The vertical component of a field in the layout of displacements; not a
    /// number where it is beyond a limit.
    template <int dim>
    class VerticalComponent : public DataPostprocessorScalar<dim>
    {
    public:
      explicit VerticalComponent(
        const std::string &name,
        const double       limit = std::numeric_limits<double>::infinity())
        : DataPostprocessorScalar<dim>(name, update_values)
        , limit(limit)
      {}

      void
      evaluate_vector_field(
        const DataPostprocessorInputs::Vector<dim> &inputs,
        std::vector<Vector<double>>                &quantities) const override
      {
        for (unsigned int q = 0; q < quantities.size(); ++q)
          {
            const double value = inputs.solution_values[q](dim - 1);
            quantities[q](0) =
              value < limit ? value : std::numeric_limits<double>::quiet_NaN();
          }
      }

    private:
      const double limit;
    };



    /// Puts a number in place of those that are none, which no interpolation
    /// would bear: larger than any other by so much that it cannot be mistaken,
    /// but not so much that its rounding errors matter.
    /// @return a limit below it.
    double
    replace_missing_entries(VectorType &vector)
    {
      double largest = 0;
      for (const double value : vector)
        if (std::isfinite(value))
          largest = std::max(largest, std::abs(value));
      largest = Utilities::MPI::max(largest, vector.get_mpi_communicator());
      const double replacement = largest > 0. ? 1e6 * largest : 1.;
      for (double &value : vector)
        if (!std::isfinite(value))
          value = replacement;
      vector.update_ghost_values();
      return 0.5 * replacement;
    }



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



    /// Output on the faces of some boundaries only.
    template <int dim>
    class BoundaryOutput : public DataOutFaces<dim>
    {
    public:
      using FaceDescriptor = typename DataOutFaces<dim>::FaceDescriptor;

      explicit BoundaryOutput(const std::set<types::boundary_id> &boundaries)
        : boundaries(boundaries)
      {}

      void
      add_vector(const DoFHandler<dim> &dof_handler,
                 const VectorType      &field,
                 const std::string     &name)
      {
        this->add_data_vector(
          dof_handler,
          field,
          std::vector<std::string>(dim, name),
          std::vector<Interpretation>(
            dim, DataComponentInterpretation::component_is_part_of_vector));
      }

      FaceDescriptor
      first_face() override
      {
        return skip_others(DataOutFaces<dim>::first_face());
      }

      FaceDescriptor
      next_face(const FaceDescriptor &face) override
      {
        return skip_others(DataOutFaces<dim>::next_face(face));
      }

      /// Whether there are no such faces of locally owned cells.
      bool
      empty() const
      {
        return this->get_patches().empty();
      }

    private:
      /// (There may be no face at all: then @p face is at no cell.)
      FaceDescriptor
      skip_others(FaceDescriptor face)
      {
        while (face.first.state() == IteratorState::valid &&
               boundaries.count(face.first->face(face.second)->boundary_id()) ==
                 0)
          face = DataOutFaces<dim>::next_face(face);
        return face;
      }

      const std::set<types::boundary_id> boundaries;
    };
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
      output, solution.dof_handler.get_communicator(), "solution", name, time);
  }



  template <int dim>
  void
  FieldOutput<dim>::write_surface(const Solution    &solution,
                                  const std::string &name,
                                  const double       time)
  {
    SurfaceFields       fields = surface_fields(solution.dof_handler,
                                          solution.constraints,
                                          solution.contact,
                                          solution.displacement,
                                          solution.residual);
    const double        limit  = replace_missing_entries(fields.gap);
    BoundaryOutput<dim> output(solution.contact_boundaries);
    output.add_vector(solution.dof_handler,
                      fields.displacement,
                      "displacement");

    const VerticalComponent<dim> gap_component("gap", limit);
    const VerticalComponent<dim> pressure_component("contact_pressure");
    const VerticalComponent<dim> active_component("active");
    output.add_data_vector(solution.dof_handler, fields.gap, gap_component);
    output.add_data_vector(solution.dof_handler,
                           fields.pressure,
                           pressure_component);
    output.add_data_vector(solution.dof_handler,
                           fields.active,
                           active_component);

    VectorType                   slip;
    const VerticalComponent<dim> stick_component("stick");
    if (solution.contact.has_friction())
      {
        slip = solution.slip;
        solution.constraints.distribute(slip);
        replace_by_ghosted_copy(slip, solution.dof_handler);
        output.add_vector(solution.dof_handler, fields.shear, "contact_shear");
        output.add_vector(solution.dof_handler, slip, "slip");
        output.add_data_vector(solution.dof_handler,
                               fields.stick,
                               stick_component);
      }

    output.set_flags(flags_with_units(parameters.units));
    output.build_patches(solution.dof_handler.get_fe().degree);
    write_files(
      output, solution.dof_handler.get_communicator(), "surface", name, time);
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
    const std::string &directory = parameters.directory;
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const std::string  stem    = kind + "-" + name;
    const auto         piece   = [&](const unsigned int r) {
      return stem + "." + Utilities::int_to_string(r, 4) + ".vtu";
    };
    checked_write(communicator,
                  output.empty() ? "" : directory + "/" + piece(rank),
                  [&](std::ostream &file) { output.write_vtu(file); });

    // ParaView does not like empty pieces.
    const auto is_empty =
      Utilities::MPI::all_gather(communicator, int(output.empty()));
    std::vector<std::string> pieces;
    for (unsigned int r = 0; r < n_ranks; ++r)
      if (!is_empty[r])
        pieces.push_back(piece(r));
    const bool first_rank = (rank == 0);
    checked_write(communicator,
                  first_rank ? directory + "/" + stem + ".pvtu" : "",
                  [&](std::ostream &file) {
                    output.write_pvtu_record(file, pieces);
                  });

    auto &record = records[kind];
    if (!record.empty() && record.back().second == stem + ".pvtu")
      record.pop_back();
    record.emplace_back(time, stem + ".pvtu");
    checked_write(communicator,
                  first_rank ? directory + "/" + kind + ".pvd" : "",
                  [&](std::ostream &file) {
                    DataOutBase::write_pvd_record(file, record);
                  });
  }



  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace ElastoPlastic
