// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include "equilibrium/johnson_mercier.h"
#include "equilibrium/tetrahedron_stress.h"
#include "io/checked_write.h"
#include "io/equilibrium_output.h"

namespace ElastoPlastic
{
  namespace
  {
    /// After the vectors.
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



    /// Patches are triangles or tetrahedra: deal.II writes them as such.
    template <int dim>
    class Simplices : public DataOutInterface<dim, dim>
    {
    public:
      using Patch = DataOutBase::Patch<dim, dim>;

      explicit Simplices(const std::vector<std::string> &names_of_vectors)
        : names_of_vectors(names_of_vectors)
      {}

      void
      add(Patch patch)
      {
        patch.patch_index = patches.size();
        patches.push_back(patch);
      }

    private:
      const std::vector<Patch> &
      get_patches() const override
      {
        return patches;
      }

      std::vector<std::string>
      get_dataset_names() const override
      {
        std::vector<std::string> result;
        for (const std::string &name : names_of_vectors)
          result.insert(result.end(), 3, name);
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
        decltype(this->get_nonscalar_data_ranges()) ranges;
        unsigned int                                first = 0;
        for (const std::string &name : names_of_vectors)
          {
            ranges.emplace_back(first,
                                first + 2,
                                name,
                                component_is_part_of_vector);
            first += 3;
          }
        ranges.emplace_back(first,
                            first + 8,
                            "stress",
                            component_is_part_of_tensor);
        return ranges;
      }

      const std::vector<std::string> names_of_vectors;
      std::vector<Patch>             patches;
    };



    /// What is not a vector, at vertex @p i of a @p patch: the components from
    /// @p first on.
    template <typename Patch>
    void
    set_stress(Patch                       &patch,
               const unsigned int           first,
               const unsigned int           i,
               const SymmetricTensor<2, 3> &stress,
               const double                 yield_radius)
    {
      const double deviator_norm = deviator(stress).norm();
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          patch.data(first + 3 * a + b, i) = stress[a][b];
      patch.data(first + 9, i)  = std::sqrt(1.5) * deviator_norm;
      patch.data(first + 10, i) = deviator_norm / yield_radius;
    }



    DataOutBase::Patch<2, 2>
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

      DataOutBase::Patch<2, 2> patch;
      patch.reference_cell = ReferenceCells::Triangle;
      patch.n_subdivisions = 1;
      patch.data.reinit(6 + names.size(), 3);
      for (unsigned int i = 0; i < 3; ++i)
        {
          patch.vertices[i] = corners[i];
          for (unsigned int d = 0; d < 2; ++d)
            {
              patch.data(d, i)     = motions[i][d];
              patch.data(3 + d, i) = multipliers[i][d];
            }
          set_stress(patch,
                     6,
                     i,
                     stress_field.without_weight(body, t, subtriangle, i),
                     body.materials[t].yield_radius);
          patch.data(17, i) = errors[t];
          patch.data(18, i) = body.mesh.cells[triangle.cell].material_id;
        }
      return patch;
    }



    DataOutBase::Patch<3, 3>
    make_patch(const SpaceFields &fields,
               const unsigned int t,
               const unsigned int part)
    {
      const auto &[body, bounds] = fields;
      const auto &tetrahedron    = body.mesh.tetrahedra[t];
      const auto  corners =
        TetrahedronStress::part_of(body.mesh.corners(tetrahedron), part);
      CornerVelocities velocity = bounds.velocity.velocity[t];
      velocity[part] =
        0.25 * (velocity[0] + velocity[1] + velocity[2] + velocity[3]);

      DataOutBase::Patch<3, 3> patch;
      patch.reference_cell = ReferenceCells::Tetrahedron;
      patch.n_subdivisions = 1;
      patch.data.reinit(3 + names.size(), 4);
      for (unsigned int i = 0; i < 4; ++i)
        {
          patch.vertices[i] = corners[i];
          for (unsigned int d = 0; d < 3; ++d)
            patch.data(d, i) = velocity[i][d];
          set_stress(patch,
                     3,
                     i,
                     bounds.stress.at(t, part, i) -
                       body.pressure_of_body_force(corners[i],
                                                   bounds.stress.load_factor) *
                         unit_symmetric_tensor<3>(),
                     body.materials[t].yield_radius);
          patch.data(14, i) = bounds.gaps[t];
          patch.data(15, i) = body.mesh.cells[tetrahedron.cell].material_id;
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
    Simplices<2> triangles({name_of_motion, "discontinuous_" + name_of_motion});
    for (unsigned int t = 0; t < fields.body.mesh.triangles.size(); ++t)
      for (unsigned int subtriangle = 0; subtriangle < 3; ++subtriangle)
        triangles.add(make_patch(fields, t, subtriangle));
    write_file(triangles, cycle);
  }



  void
  EquilibriumOutput::write(const SpaceFields &fields, const unsigned int cycle)
  {
    Simplices<3> tetrahedra({name_of_motion});
    for (unsigned int t = 0; t < fields.body.mesh.tetrahedra.size(); ++t)
      for (unsigned int k = 0; k < TetrahedronStress::n_parts; ++k)
        tetrahedra.add(make_patch(fields, t, k));
    write_file(tetrahedra, cycle);
  }



  template <typename Simplices>
  void
  EquilibriumOutput::write_file(Simplices &simplices, const unsigned int cycle)
  {
    DataOutBase::VtkFlags flags;
    if (units.are_named())
      for (const std::string field : {"stress", "von_mises_stress"})
        flags.physical_units[field] = units.of("stress");
    simplices.set_flags(flags);

    const std::string file_name =
      name + "-" + Utilities::int_to_string(cycle, 3) + ".vtu";
    checked_write(MPI_COMM_SELF,
                  directory + "/" + file_name,
                  [&](std::ostream &file) { simplices.write_vtu(file); });
    records.emplace_back(cycle, file_name);
    checked_write(MPI_COMM_SELF,
                  directory + "/" + name + ".pvd",
                  [&](std::ostream &file) {
                    DataOutBase::write_pvd_record(file, records);
                  });
  }
} // namespace ElastoPlastic
