// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "bounds/equilibrium_output.h"
#include "bounds/stress/johnson_mercier.h"
#include "bounds/stress/tetrahedron_stress.h"
#include "output/patches.h"

namespace ElastoPlastic
{
  namespace
  {
    /// After the motions: stress, von Mises stress, yield ratio, error
    /// indicator, material.
    constexpr unsigned int n_other_components = 13;



    /// With the plastic work, if there is a mechanism, as the last field.
    template <int dim>
    Patches<dim>
    make_patches(const std::vector<std::string> &motions,
                 const bool                      has_plastic_work)
    {
      std::vector<typename Patches<dim>::Field> fields;
      const auto add = [&](const std::vector<std::string> &names,
                           const unsigned int              n_components) {
        for (const std::string &name : names)
          fields.push_back({name, n_components});
      };
      add(motions, 3);
      add({"stress"}, 9);
      add({"von_mises_stress", "yield_ratio", "error_indicator", "material_id"},
          1);
      if (has_plastic_work)
        add({"plastic_work"}, 1);
      return Patches<dim>(fields);
    }



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
      const auto &[body, stress_field, motion, errors, work] = fields;
      const auto &triangle = body.mesh.triangles[t];
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
      patch.data.reinit(6 + n_other_components + (work.empty() ? 0 : 1), 3);
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
          if (!work.empty())
            patch.data(19, i) = work[t];
        }
      return patch;
    }



    DataOutBase::Patch<3, 3>
    make_patch(const SpaceFields &fields,
               const unsigned int t,
               const unsigned int part)
    {
      const auto &[body, stress, motion, errors, work] = fields;
      const auto &tetrahedron = body.mesh.tetrahedra[t];
      const auto  corners =
        TetrahedronStress::part_of(body.mesh.corners(tetrahedron), part);

      DataOutBase::Patch<3, 3> patch;
      patch.reference_cell = ReferenceCells::Tetrahedron;
      patch.n_subdivisions = 1;
      patch.data.reinit(3 + n_other_components + (work.empty() ? 0 : 1), 4);
      for (unsigned int i = 0; i < 4; ++i)
        {
          patch.vertices[i] = corners[i];
          for (unsigned int d = 0; d < 3; ++d)
            patch.data(d, i) = motion[t][i == part ? 4 : i][d];
          set_stress(patch,
                     3,
                     i,
                     stress.at(t, part, i) -
                       body.pressure_of_body_force(corners[i],
                                                   stress.load_factor) *
                         unit_symmetric_tensor<3>(),
                     body.materials[t].yield_radius);
          patch.data(14, i) = errors[t];
          patch.data(15, i) = body.mesh.cells[tetrahedron.cell].material_id;
          if (!work.empty())
            patch.data(16, i) = work[t];
        }
      return patch;
    }
  } // namespace



  EquilibriumOutput::EquilibriumOutput(const OutputParameters &parameters,
                                       const std::string      &name,
                                       const std::string      &name_of_motion)
    : series(parameters, name)
    , name_of_motion(name_of_motion)
  {}



  void
  EquilibriumOutput::write(const EquilibriumFields &fields,
                           const unsigned int       cycle)
  {
    auto triangles =
      make_patches<2>({name_of_motion, "discontinuous_" + name_of_motion},
                      !fields.plastic_work.empty());
    for (unsigned int t = 0; t < fields.body.mesh.triangles.size(); ++t)
      for (unsigned int subtriangle = 0; subtriangle < 3; ++subtriangle)
        triangles.add(make_patch(fields, t, subtriangle));
    series.write(triangles, cycle);
  }



  void
  EquilibriumOutput::write(const SpaceFields &fields, const unsigned int cycle)
  {
    auto tetrahedra =
      make_patches<3>({name_of_motion}, !fields.plastic_work.empty());
    for (unsigned int t = 0; t < fields.body.mesh.tetrahedra.size(); ++t)
      for (unsigned int k = 0; k < TetrahedronStress::n_parts; ++k)
        tetrahedra.add(make_patch(fields, t, k));
    series.write(tetrahedra, cycle);
  }
} // namespace ElastoPlastic
