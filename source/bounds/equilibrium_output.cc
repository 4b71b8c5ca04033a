// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "bounds/body/yield_norms.h"
#include "bounds/conic/tolerances.h"
#include "bounds/equilibrium_output.h"
#include "bounds/mechanism/face_view.h"
#include "bounds/stress/johnson_mercier.h"
#include "output/patches.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The values at a corner of a part, in the order of the fields.
    template <int dim>
    std::vector<double>
    values_at(const EquilibriumFields<dim> &fields,
              const unsigned int            t,
              const unsigned int            part,
              const unsigned int            corner)
    {
      const auto         &body = fields.body;
      std::vector<double> values;
      const auto          add = [&](const Tensor<1, dim> &vector) {
        for (unsigned int d = 0; d < 3; ++d)
          values.push_back(d < dim ? vector[d] : 0.);
      };
      add(
        fields.motion(t,
                      point_of_part<dim>(part, corner_position<dim>(corner))));
      if (dim == 2)
        add(on_part<dim>(fields.stress.displacement[t], part)[corner]);
      const auto stress = fields.stress.without_weight(body, t, part, corner);
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          values.push_back(stress[a][b]);
      values.push_back(std::sqrt(1.5) * deviator(stress).norm());
      values.push_back(stress_norm(body.materials[t], stress) /
                       body.yield_radius(t, stress));
      values.push_back(fields.errors[t]);
      values.push_back(
        body.mesh.cells[body.mesh.simplices[t].cell].material_id);
      if (!fields.plastic_work.empty())
        values.push_back(fields.plastic_work[t]);
      return values;
    }



    template <int dim>
    DataOutBase::Patch<dim, dim>
    make_patch(const EquilibriumFields<dim> &fields,
               const unsigned int            t,
               const unsigned int            part)
    {
      const auto corners =
        JohnsonMercier<dim>::part_of(fields.body.corners_of(t), part);
      DataOutBase::Patch<dim, dim> patch;
      patch.reference_cell = ReferenceCells::get_simplex<dim>();
      patch.n_subdivisions = 1;
      for (unsigned int i = 0; i <= dim; ++i)
        {
          patch.vertices[i] = corners[i];
          const auto values = values_at(fields, t, part, i);
          if (i == 0)
            patch.data.reinit(values.size(), dim + 1);
          for (unsigned int c = 0; c < values.size(); ++c)
            patch.data(c, i) = values[c];
        }
      return patch;
    }
  } // namespace



  template <int dim>
  void
  EquilibriumOutput<dim>::write(const EquilibriumFields<dim> &fields,
                                const unsigned int            cycle)
  {
    std::vector<typename Patches<dim>::Field> names = {{name_of_motion, 3}};
    if (dim == 2)
      names.push_back({"discontinuous_" + name_of_motion, 3});
    names.insert(names.end(),
                 {{"stress", 9},
                  {"von_mises_stress", 1},
                  {"yield_ratio", 1},
                  {"error_indicator", 1},
                  {"material_id", 1}});
    if (!fields.plastic_work.empty())
      names.push_back({"plastic_work", 1});
    Patches<dim> patches(names);
    for (unsigned int t = 0; t < fields.body.mesh.simplices.size(); ++t)
      for (unsigned int part = 0; part < JohnsonMercier<dim>::n_parts; ++part)
        patches.add(make_patch(fields, t, part));
    series.write(patches, cycle);
  }



  // A patch has the points of a polynomial of the degree of the slip, in
  // their order on a side. On the axis, nothing slides.
  template <int dim>
  void
  SlipOutput<dim>::write(const SplitBody<dim>                    &body,
                         const std::vector<SimplexVelocity<dim>> &velocity,
                         const unsigned int                       cycle)
  {
    const double threshold =
      Tolerance::smallest_slip * largest_velocity(body, velocity);
    const auto           &points = Bernstein<dim - 1>::points(slip_degree<dim>);
    Patches<dim - 1, dim> patches({{"slip", 3}});
    for (const auto &view : views_of_faces(body))
      {
        if (!view.resists_slip())
          continue;
        DataOutBase::Patch<dim - 1, dim> patch;
        patch.reference_cell = ReferenceCells::get_simplex<dim - 1>();
        patch.n_subdivisions = slip_degree<dim>;
        for (unsigned int i = 0; i < dim; ++i)
          patch.vertices[i] = view.corners[i];
        patch.data.reinit(3, points.size());
        double largest = 0;
        for (unsigned int p = 0; p < points.size(); ++p)
          {
            const Point<dim> x = interpolate(points[p], view.corners);
            if (body.is_on_axis(x))
              continue;
            const Tensor<1, dim> slip =
              view.along(view.jump(velocity, points[p])) / body.weight(x);
            for (unsigned int d = 0; d < dim; ++d)
              patch.data(d, p) = slip[d];
            largest = std::max(largest, slip.norm());
          }
        if (largest > threshold)
          patches.add(patch);
      }
    series.write(patches, cycle);
  }



  template class EquilibriumOutput<2>;
  template class EquilibriumOutput<3>;
  template class SlipOutput<2>;
  template class SlipOutput<3>;
} // namespace ElastoPlastic
