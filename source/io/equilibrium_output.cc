// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include "equilibrium/johnson_mercier.h"
#include "io/checked_write.h"
#include "io/equilibrium_output.h"

namespace ElastoPlastic
{
  namespace
  {
    using Patch = DataOutBase::Patch<2, 2>;

    /// After the three components of the motion and of its discontinuous
    /// relative.
    const std::vector<std::string> names = {"stress",
                                            "stress",
                                            "stress",
                                            "stress",
                                            "stress",
                                            "stress",
                                            "stress",
                                            "stress",
                                            "stress",
                                            "von_mises_stress",
                                            "yield_ratio",
                                            "error_indicator",
                                            "material_id"};



    /// Patches are triangles: deal.II writes them as such.
    class Triangles : public DataOutInterface<2, 2>
    {
    public:
      explicit Triangles(const std::string &name_of_motion)
        : name_of_motion(name_of_motion)
        , name_of_multiplier("discontinuous_" + name_of_motion)
      {}

      std::vector<Patch> patches;

    private:
      const std::vector<Patch> &
      get_patches() const override
      {
        return patches;
      }

      std::vector<std::string>
      get_dataset_names() const override
      {
        std::vector<std::string> result(3, name_of_motion);
        result.insert(result.end(), 3, name_of_multiplier);
        result.insert(result.end(), names.begin(), names.end());
        return result;
      }

      std::vector<
        std::tuple<unsigned int,
                   unsigned int,
                   std::string,
                   DataComponentInterpretation::DataComponentInterpretation>>
      get_nonscalar_data_ranges() const override
      {
        using namespace DataComponentInterpretation;
        return {{0, 2, name_of_motion, component_is_part_of_vector},
                {3, 5, name_of_multiplier, component_is_part_of_vector},
                {6, 14, "stress", component_is_part_of_tensor}};
      }

      const std::string name_of_motion, name_of_multiplier;
    };



    Patch
    make_patch(const EquilibriumFields &fields,
               const unsigned int       t,
               const unsigned int       subtriangle)
    {
      const auto &[body, stress_field, motion, errors] = fields;
      const auto &triangle                             = body.mesh.triangles[t];
      const auto  corners =
        JohnsonMercier::subtriangle_of(body.mesh.corners(triangle),
                                       subtriangle);
      const std::array<Tensor<1, 2>, 3> motions = {
        {motion[t][subtriangle],
         motion[t][(subtriangle + 1) % 3],
         motion[t][3]}};

      const auto multipliers =
        JohnsonMercier::on_subtriangle(stress_field.displacement[t],
                                       subtriangle);

      Patch patch;
      patch.reference_cell = ReferenceCells::Triangle;
      patch.n_subdivisions = 1;
      patch.data.reinit(6 + names.size(), 3);
      for (unsigned int i = 0; i < 3; ++i)
        {
          patch.vertices[i] = corners[i];
          const auto stress =
            stress_field.without_weight(body, t, subtriangle, i);
          const double deviator_norm = deviator(stress).norm();
          for (unsigned int d = 0; d < 2; ++d)
            {
              patch.data(d, i)     = motions[i][d];
              patch.data(3 + d, i) = multipliers[i][d];
            }
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b < 3; ++b)
              patch.data(6 + 3 * a + b, i) = stress[a][b];
          patch.data(15, i) = std::sqrt(1.5) * deviator_norm;
          patch.data(16, i) = deviator_norm / body.materials[t].yield_radius;
          patch.data(17, i) = errors[t];
          patch.data(18, i) = body.mesh.cells[triangle.cell].material_id;
        }
      return patch;
    }
  } // namespace



  EquilibriumOutput::EquilibriumOutput(const OutputParameters &parameters,
                                       const std::string      &name,
                                       const std::string      &name_of_motion)
    : directory(parameters.directory)
    , units(parameters.units)
    , name(name)
    , name_of_motion(name_of_motion)
  {}



  void
  EquilibriumOutput::write(const EquilibriumFields &fields,
                           const unsigned int       cycle)
  {
    Triangles             triangles(name_of_motion);
    DataOutBase::VtkFlags flags;
    if (units.are_named())
      for (const std::string field : {"stress", "von_mises_stress"})
        flags.physical_units[field] = units.of("stress");
    triangles.set_flags(flags);
    for (unsigned int t = 0; t < fields.body.mesh.triangles.size(); ++t)
      for (unsigned int subtriangle = 0; subtriangle < 3; ++subtriangle)
        {
          triangles.patches.push_back(make_patch(fields, t, subtriangle));
          triangles.patches.back().patch_index = triangles.patches.size() - 1;
        }

    const std::string file_name =
      name + "-" + Utilities::int_to_string(cycle, 3) + ".vtu";
    checked_write(MPI_COMM_SELF,
                  directory + "/" + file_name,
                  [&](std::ostream &file) { triangles.write_vtu(file); });
    records.emplace_back(cycle, file_name);
    checked_write(MPI_COMM_SELF,
                  directory + "/" + name + ".pvd",
                  [&](std::ostream &file) {
                    DataOutBase::write_pvd_record(file, records);
                  });
  }
} // namespace ElastoPlastic
