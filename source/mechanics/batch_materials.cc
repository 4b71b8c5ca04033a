// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/exceptions.h"
#include "mechanics/batch_materials.h"
#include "mechanics/quadrature_points.h"
#include "mesh/material_ids.h"

namespace ElastoPlastic
{
  unsigned int
  BatchMaterials::n_back_stresses() const
  {
    unsigned int n = 0;
    for (const Material<double> &material : materials)
      n = std::max<unsigned int>(n, material.back_stresses.size());
    return n;
  }



  bool
  BatchMaterials::are_nearly_incompressible() const
  {
    return std::any_of(materials.begin(),
                       materials.end(),
                       is_nearly_incompressible);
  }



  void
  BatchMaterials::set_step_duration(const double duration)
  {
    for (Material<double> &material : materials)
      material.step_duration = duration;
    for (Material<Number> &material : of_batches)
      material.step_duration = duration;
  }



  bool
  BatchMaterials::become_steeper() const
  {
    return std::any_of(materials.begin(),
                       materials.end(),
                       [](const Material<double> &material) {
                         return material.curves[0] &&
                                !material.curves[0]->is_concave();
                       });
  }



  template <typename Cell>
  const Material<double> &
  BatchMaterials::of_cell(const Cell &cell) const
  {
    if (materials.size() == 1)
      return materials.front();
    check_material_id(cell, materials.size());
    return materials[cell.material_id()];
  }



  // Lanes without a cell get any material.
  template <int dim>
  void
  BatchMaterials::reinit(const CellKernel<dim, PointTangents<dim>> &kernel,
                         const unsigned int                         n_points,
                         const MPI_Comm communicator)
  {
    const bool vary =
      std::any_of(materials.begin(), materials.end(), has_varying_criterion);
    n_per_batch = vary ? n_points : materials.size() == 1 ? 0 : 1;
    std::array<const Material<double> *, Number::size()> of_lane;
    of_lane.fill(&materials.front());
    of_batches.assign(std::max(1U, n_per_batch * kernel.n_batches()),
                      join_lanes<Number>(of_lane, n_back_stresses()));
    if (n_per_batch == 0)
      return;
    rethrow_collectively(communicator, [&]() {
      for (unsigned int batch = 0; batch < kernel.n_batches(); ++batch)
        {
          for (unsigned int lane = 0; lane < kernel.n_cells(batch); ++lane)
            {
              const auto cell = kernel.cell(batch, lane);
              of_lane[lane]   = &of_cell(*cell);
            }
          std::fill_n(of_batches.begin() + n_per_batch * batch,
                      n_per_batch,
                      join_lanes<Number>(of_lane, n_back_stresses()));
        }
      if (vary)
        set_criteria_at_points(kernel);
    });
  }



  template <int dim>
  void
  BatchMaterials::set_criteria_at_points(
    const CellKernel<dim, PointTangents<dim>> &kernel)
  {
    for_each_quadrature_point<dim>(
      kernel,
      n_per_batch,
      [&](const unsigned int batch,
          const unsigned int lane,
          const unsigned int q,
          const Point<dim>  &place) {
        const Material<double> &material = of_cell(*kernel.cell(batch, lane));
        if (!has_varying_criterion(material))
          return;
        Point<3> in_space;
        for (unsigned int d = 0; d < dim; ++d)
          in_space[d] = place[d];
        of_batches[n_per_batch * batch + q].criteria[lane] =
          std::make_shared<GeneralCriterion>(material.criterion_at(in_space));
      });
  }



  template void
  BatchMaterials::reinit(const CellKernel<2, PointTangents<2>> &,
                         const unsigned int,
                         const MPI_Comm);
  template void
  BatchMaterials::reinit(const CellKernel<3, PointTangents<3>> &,
                         const unsigned int,
                         const MPI_Comm);
} // namespace ElastoPlastic
