// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>

#include "io/body_output.h"
#include "mechanics/ghosted_copy.h"
#include "mesh/owned_cells.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The rows of a patch's data.
    template <int dim>
    struct Rows
    {
      static constexpr unsigned int displacement   = 0;
      static constexpr unsigned int stress         = dim;
      static constexpr unsigned int plastic_strain = stress + dim * dim;
      static constexpr unsigned int von_mises      = plastic_strain + dim * dim;
      static constexpr unsigned int alpha          = von_mises + 1;
      static constexpr unsigned int out_of_plane   = alpha + 1; // in 2D only
      static constexpr unsigned int plastic_fraction =
        alpha + (dim == 2 ? 2 : 1);
      static constexpr unsigned int error_indicator = plastic_fraction + 1;
      static constexpr unsigned int material_id     = error_indicator + 1;
      static constexpr unsigned int subdomain       = material_id + 1;
      static constexpr unsigned int n               = subdomain + 1;
    };



    /// The values at one quadrature point, in the rows from stress on.
    template <int dim>
    std::array<float, Rows<dim>::n>
    values_at(const PointResult &point)
    {
      using R = Rows<dim>;
      std::array<float, R::n> values{};
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          {
            values[R::stress + dim * i + j] = point.stress[i][j];
            values[R::plastic_strain + dim * i + j] =
              point.plastic_strain[i][j];
          }
      values[R::von_mises] = std::sqrt(1.5) * deviator(point.stress).norm();
      values[R::alpha]     = point.equivalent_plastic_strain;
      if (dim == 2)
        values[R::out_of_plane] = point.stress[2][2];
      return values;
    }
  } // namespace



  template <int dim>
  BodyOutput<dim>::BodyOutput(const DoFHandler<dim>    &dof_handler,
                              const VectorType         &displacement,
                              const SolidOperator<dim> &solid,
                              const Vector<float>      &error_indicators)
  {
    using R                     = Rows<dim>;
    const unsigned int degree   = dof_handler.get_fe().degree;
    const unsigned int n_points = Utilities::pow(degree + 1, dim);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          Patch &patch         = patches.emplace_back();
          patch.patch_index    = patches.size() - 1;
          patch.n_subdivisions = degree;
          for (const unsigned int v : cell->vertex_indices())
            patch.vertices[v] = cell->vertex(v);
          patch.data.reinit(R::n, n_points);
          for (unsigned int i = 0; i < n_points; ++i)
            {
              patch.data(R::error_indicator, i) =
                error_indicators(cell->active_cell_index());
              patch.data(R::material_id, i) = cell->material_id();
              patch.data(R::subdomain, i)   = cell->subdomain_id();
            }
        }
    add_displacement(dof_handler, displacement);
    add_point_fields(dof_handler, displacement, solid);
  }



  template <int dim>
  void
  BodyOutput<dim>::add_displacement(const DoFHandler<dim> &dof_handler,
                                    const VectorType      &displacement)
  {
    const VectorType u  = ghosted_copy(displacement, dof_handler);
    const auto      &fe = dof_handler.get_fe();
    const auto       to_lexicographic =
      FETools::hierarchic_to_lexicographic_numbering<dim>(fe.degree);
    Vector<double> values(fe.n_dofs_per_cell());
    auto           patch = patches.begin();
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_values(u, values);
          for (unsigned int i = 0; i < values.size(); ++i)
            {
              const auto [component, node] = fe.system_to_component_index(i);
              patch->data(Rows<dim>::displacement + component,
                          to_lexicographic[node]) = values(i);
            }
          ++patch;
        }
  }



  template <int dim>
  void
  BodyOutput<dim>::add_point_fields(const DoFHandler<dim>    &dof_handler,
                                    const VectorType         &displacement,
                                    const SolidOperator<dim> &solid)
  {
    using R                                = Rows<dim>;
    const unsigned int              degree = dof_handler.get_fe().degree;
    const FE_DGQArbitraryNodes<dim> point_space(QGauss<1>(degree + 1));
    const QIterated<dim>            patch_points(QTrapezoid<1>(), degree);
    const unsigned int              n_points = patch_points.size();
    FullMatrix<float>               extrapolation(n_points, n_points);
    for (unsigned int q = 0; q < n_points; ++q)
      for (unsigned int i = 0; i < n_points; ++i)
        extrapolation(q, i) = point_space.shape_value(q, patch_points.point(i));

    const OwnedCells<dim> cells(dof_handler.get_triangulation());
    solid.for_each_point(
      displacement,
      [&](const auto &cell, const unsigned int q, const PointResult &point) {
        auto      &data   = patches[cells.number(*cell)].data;
        const auto values = values_at<dim>(point);
        for (unsigned int row = R::stress; row < R::plastic_fraction; ++row)
          for (unsigned int i = 0; i < n_points; ++i)
            data(row, i) += extrapolation(q, i) * values[row];
        if (point.plastic)
          for (unsigned int i = 0; i < n_points; ++i)
            data(R::plastic_fraction, i) += 1.f / n_points;
      });
  }



  template <int dim>
  const std::vector<typename BodyOutput<dim>::Patch> &
  BodyOutput<dim>::get_patches() const
  {
    return patches;
  }



  template <int dim>
  std::vector<std::string>
  BodyOutput<dim>::get_dataset_names() const
  {
    std::vector<std::string> names(dim, "displacement");
    names.insert(names.end(), dim * dim, "stress");
    names.insert(names.end(), dim * dim, "plastic_strain");
    names.push_back("von_mises_stress");
    names.push_back("equivalent_plastic_strain");
    if (dim == 2)
      names.push_back("out_of_plane_stress");
    for (const auto *const name :
         {"plastic_fraction", "error_indicator", "material_id", "subdomain"})
      names.push_back(name);
    return names;
  }



  template <int dim>
  std::vector<typename BodyOutput<dim>::Range>
  BodyOutput<dim>::get_nonscalar_data_ranges() const
  {
    using R = Rows<dim>;
    return {{R::displacement,
             R::stress - 1,
             "displacement",
             DataComponentInterpretation::component_is_part_of_vector},
            {R::stress,
             R::plastic_strain - 1,
             "stress",
             DataComponentInterpretation::component_is_part_of_tensor},
            {R::plastic_strain,
             R::von_mises - 1,
             "plastic_strain",
             DataComponentInterpretation::component_is_part_of_tensor}};
  }



  template class BodyOutput<2>;
  template class BodyOutput<3>;
} // namespace ElastoPlastic
