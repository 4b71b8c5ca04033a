// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include "base/exceptions.h"
#include "mechanics/batch_materials.h"
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



  // Lanes without a cell get any material.
  template <int dim>
  void
  BatchMaterials::reinit(const CellKernel<dim, PointTangents<dim>> &kernel,
                         const MPI_Comm communicator)
  {
    std::array<const Material<double> *, Number::size()> of_lane;
    of_lane.fill(&materials.front());
    of_batches.assign(materials.size() == 1 ? 1 : kernel.n_batches(),
                      join_lanes<Number>(of_lane, n_back_stresses()));
    if (materials.size() == 1)
      return;
    rethrow_collectively(communicator, [&]() {
      for (unsigned int batch = 0; batch < kernel.n_batches(); ++batch)
        {
          for (unsigned int lane = 0; lane < kernel.n_cells(batch); ++lane)
            {
              const auto cell = kernel.cell(batch, lane);
              check_material_id(*cell, materials.size());
              of_lane[lane] = &materials[cell->material_id()];
            }
          of_batches[batch] = join_lanes<Number>(of_lane, n_back_stresses());
        }
    });
  }



  template void
  BatchMaterials::reinit(const CellKernel<2, PointTangents<2>> &,
                         const MPI_Comm);
  template void
  BatchMaterials::reinit(const CellKernel<3, PointTangents<3>> &,
                         const MPI_Comm);
} // namespace ElastoPlastic
