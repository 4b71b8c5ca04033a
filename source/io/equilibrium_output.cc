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

    const std::vector<std::string> names = {"velocity",
                                            "velocity",
                                            "velocity",
                                            "stress",
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
        return names;
      }

      std::vector<
        std::tuple<unsigned int,
                   unsigned int,
                   std::string,
                   DataComponentInterpretation::DataComponentInterpretation>>
      get_nonscalar_data_ranges() const override
      {
        using namespace DataComponentInterpretation;
        return {{0, 2, "velocity", component_is_part_of_vector},
                {3, 11, "stress", component_is_part_of_tensor}};
      }
    };



    SymmetricTensor<2, 3>
    stress_at(const StressField &field,
              const unsigned int t,
              const unsigned int third,
              const unsigned int corner)
    {
      const auto in_plane =
        JohnsonMercier::stress_at(field.in_plane[t], third, corner);
      SymmetricTensor<2, 3> stress;
      stress[0][0] = in_plane[0][0];
      stress[1][1] = in_plane[1][1];
      stress[0][1] = in_plane[0][1];
      stress[2][2] = field.out_of_plane[t][3 * third + corner];
      return stress;
    }



    /// The value of the quadratic velocity at the centre of gravity.
    Tensor<1, 2>
    velocity_at_center(const VelocityField       &field,
                       const SplitMesh::Triangle &triangle)
    {
      Tensor<1, 2> sum;
      for (unsigned int i = 0; i < 3; ++i)
        sum += 4. * field.at_sides[triangle.sides[i]] -
               field.at_vertices[triangle.vertices[i]];
      return sum / 9.;
    }



    Patch
    make_patch(const PlaneBody   &body,
               const LimitLoad   &bounds,
               const unsigned int t,
               const unsigned int third)
    {
      const auto &triangle = body.mesh.triangles[t];
      const auto  corners =
        JohnsonMercier::third_of(body.mesh.corners(triangle), third);
      const auto                       &vertex = bounds.velocity.at_vertices;
      const std::array<Tensor<1, 2>, 3> velocities = {
        {vertex[triangle.vertices[third]],
         vertex[triangle.vertices[(third + 1) % 3]],
         velocity_at_center(bounds.velocity, triangle)}};

      Patch patch;
      patch.reference_cell = ReferenceCells::Triangle;
      patch.n_subdivisions = 1;
      patch.data.reinit(names.size(), 3);
      for (unsigned int i = 0; i < 3; ++i)
        {
          patch.vertices[i]          = corners[i];
          const auto   stress        = stress_at(bounds.stress, t, third, i);
          const double deviator_norm = deviator(stress).norm();
          for (unsigned int d = 0; d < 2; ++d)
            patch.data(d, i) = velocities[i][d];
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b < 3; ++b)
              patch.data(3 + 3 * a + b, i) = stress[a][b];
          patch.data(12, i) = std::sqrt(1.5) * deviator_norm;
          patch.data(13, i) = deviator_norm / body.materials[t].yield_radius;
          patch.data(14, i) = bounds.gaps[t];
          patch.data(15, i) = body.mesh.cells[triangle.cell].material_id;
        }
      return patch;
    }
  } // namespace



  EquilibriumOutput::EquilibriumOutput(const std::string &directory)
    : directory(directory)
  {}



  void
  EquilibriumOutput::write(const PlaneBody   &body,
                           const LimitLoad   &bounds,
                           const unsigned int cycle)
  {
    Triangles output;
    for (unsigned int t = 0; t < body.mesh.triangles.size(); ++t)
      for (unsigned int third = 0; third < 3; ++third)
        {
          output.patches.push_back(make_patch(body, bounds, t, third));
          output.patches.back().patch_index = output.patches.size() - 1;
        }

    const std::string name =
      "limit_load-" + Utilities::int_to_string(cycle, 3) + ".vtu";
    checked_write(MPI_COMM_SELF,
                  directory + "/" + name,
                  [&](std::ostream &file) { output.write_vtu(file); });
    records.emplace_back(cycle, name);
    checked_write(MPI_COMM_SELF,
                  directory + "/limit_load.pvd",
                  [&](std::ostream &file) {
                    DataOutBase::write_pvd_record(file, records);
                  });
  }
} // namespace ElastoPlastic
