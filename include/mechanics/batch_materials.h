// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mechanics_batch_materials_h
#define mechanics_batch_materials_h

#include <vector>

#include "material/material.h"
#include "mechanics/cell_kernel.h"
#include "mechanics/point_tangents.h"

namespace ElastoPlastic
{
  /// The materials of all cell batches: of each cell the one that belongs to
  /// its material id, or the only one. Where a criterion depends on the
  /// position, the points of a cell have materials of their own.
  class BatchMaterials
  {
  public:
    using Number = Simd<double>;

    explicit BatchMaterials(const std::vector<Material<double>> &materials)
      : materials(materials)
    {}


    /// Finds the materials of the cells of @p kernel, which have @p n_points
    /// quadrature points. Collective.
    /// @throws InputError if a cell's material id has no material, or an
    /// expression of the position no value.
    template <int dim>
    void
    reinit(const CellKernel<dim, PointTangents<dim>> &kernel,
           const unsigned int                         n_points,
           const MPI_Comm                             communicator);

    /// At a quadrature point.
    const Material<Number> &
    at(const unsigned int batch, const unsigned int point) const
    {
      return n_per_batch > 1 ? of_batches[n_per_batch * batch + point] :
                               (*this)[batch];
    }

    /// All of it but the criterion is the same in a cell.
    const Material<Number> &
    operator[](const unsigned int batch) const
    {
      return of_batches[n_per_batch * batch];
    }

    /// Sets how long the load step under way takes, for all materials.
    void
    set_step_duration(const double duration);

    double
    step_duration() const
    {
      return materials.front().step_duration;
    }

    /// The largest number of back stresses that a material has.
    unsigned int
    n_back_stresses() const;

    /// Whether a material hardly changes its volume.
    bool
    are_nearly_incompressible() const;

    /// Whether a back stress recovers.
    bool
    recover() const
    {
      return std::any_of(materials.begin(), materials.end(), has_recovery);
    }

    /// Whether all stresses have an incremental potential.
    bool
    have_potential() const
    {
      return std::all_of(materials.begin(), materials.end(), has_potential);
    }

    /// Whether a material has a rate law.
    bool
    are_rate_dependent() const
    {
      return std::any_of(materials.begin(), materials.end(), is_rate_dependent);
    }

    /// Whether a hardening curve becomes steeper.
    bool
    become_steeper() const;

  private:
    std::vector<Material<double>> materials;
    /// @throws InputError
    template <typename Cell>
    const Material<double> &
    of_cell(const Cell &cell) const;

    /// Sets the criteria at the quadrature points.
    template <int dim>
    void
    set_criteria_at_points(const CellKernel<dim, PointTangents<dim>> &kernel);

    /// By cell batches and, where a criterion varies, by points.
    std::vector<Material<Number>> of_batches;
    /// 0 if there is only one for all.
    unsigned int n_per_batch = 0;
  };
} // namespace ElastoPlastic

#endif
