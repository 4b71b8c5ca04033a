// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>

#include "io/body_output.h"
#include "mechanics/ghosted_copy.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr unsigned int cells_per_piece = 10000;



    /// The rows of a patch's data.
    template <int dim>
    struct Rows
    {
      static constexpr unsigned int displacement     = 0;
      static constexpr unsigned int stress           = dim;
      static constexpr unsigned int plastic_strain   = stress + 3 * 3;
      static constexpr unsigned int von_mises        = plastic_strain + 3 * 3;
      static constexpr unsigned int alpha            = von_mises + 1;
      static constexpr unsigned int plastic_fraction = alpha + 1;
      static constexpr unsigned int error_indicator  = plastic_fraction + 1;
      static constexpr unsigned int material_id      = error_indicator + 1;
      static constexpr unsigned int subdomain        = material_id + 1;
      static constexpr unsigned int n                = subdomain + 1;
    };



    /// The values at one quadrature point, in the rows from stress on.
    template <int dim>
    std::array<float, Rows<dim>::n>
    values_at(const PointResult &point)
    {
      using R = Rows<dim>;
      std::array<float, R::n> values{};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            values[R::stress + 3 * i + j]         = point.stress[i][j];
            values[R::plastic_strain + 3 * i + j] = point.plastic_strain[i][j];
          }
      values[R::von_mises] = std::sqrt(1.5) * deviator(point.stress).norm();
      values[R::alpha]     = point.equivalent_plastic_strain;
      return values;
    }


    template <int dim>
    FullMatrix<float>
    make_extrapolation(const unsigned int degree)
    {
      const FE_DGQArbitraryNodes<dim> point_space(QGauss<1>(degree + 1));
      const QIterated<dim>            patch_points(QTrapezoid<1>(), degree);
      const unsigned int              n_points = patch_points.size();
      FullMatrix<float>               extrapolation(n_points, n_points);
      for (unsigned int q = 0; q < n_points; ++q)
        for (unsigned int i = 0; i < n_points; ++i)
          extrapolation(q, i) =
            point_space.shape_value(q, patch_points.point(i));
      return extrapolation;
    }



    template <int dim>
    std::vector<std::string>
    field_names()
    {
      std::vector<std::string> names(dim, "displacement");
      names.insert(names.end(), 3 * 3, "stress");
      names.insert(names.end(), 3 * 3, "plastic_strain");
      for (const auto *const name : {"von_mises_stress",
                                     "equivalent_plastic_strain",
                                     "plastic_fraction",
                                     "error_indicator",
                                     "material_id",
                                     "subdomain"})
        names.push_back(name);
      return names;
    }



    template <int dim>
    std::vector<
      std::tuple<unsigned int,
                 unsigned int,
                 std::string,
                 DataComponentInterpretation::DataComponentInterpretation>>
    vectors_and_tensors()
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



    DataOutBase::VtkFlags
    compressed()
    {
      DataOutBase::VtkFlags flags;
      flags.compression_level = DataOutBase::VtkFlags::best_speed;
      return flags;
    }
  } // namespace



  template <int dim>
  BodyOutput<dim>::BodyOutput(const DoFHandler<dim>    &dof_handler,
                              const VectorType         &displacement,
                              const SolidOperator<dim> &solid,
                              const Vector<float>      &error_indicators)
    : dof_handler(dof_handler)
    , displacement(displacement)
    , solid(solid)
    , error_indicators(error_indicators)
    , degree(dof_handler.get_fe().degree)
    , ghosted_displacement(ghosted_copy(displacement, dof_handler))
    , to_lexicographic(
        FETools::hierarchic_to_lexicographic_numbering<dim>(degree))
    , extrapolation(make_extrapolation<dim>(degree))
    , flags(compressed())
  {}



  template <int dim>
  bool
  BodyOutput<dim>::empty() const
  {
    const auto &mesh = dynamic_cast<const parallel::TriangulationBase<dim> &>(
      dof_handler.get_triangulation());
    return mesh.n_locally_owned_active_cells() == 0;
  }



  template <int dim>
  void
  BodyOutput<dim>::write_vtu(std::ostream &out) const
  {
    std::vector<Patch> patches;
    const auto         write_piece = [&]() {
      DataOutBase::write_vtu_main(
        patches, field_names<dim>(), vectors_and_tensors<dim>(), flags, out);
      patches.clear();
    };

    DataOutBase::write_vtu_header(out, flags);
    solid.for_each_cell(displacement,
                        [&](const auto &cell, const auto &points) {
                          patches.push_back(make_patch(cell, points));
                          patches.back().patch_index = patches.size() - 1;
                          if (patches.size() == cells_per_piece)
                            write_piece();
                        });
    if (!patches.empty())
      write_piece();
    DataOutBase::write_vtu_footer(out);
  }



  template <int dim>
  void
  BodyOutput<dim>::write_pvtu_record(
    std::ostream &out, const std::vector<std::string> &file_names) const
  {
    DataOutBase::write_pvtu_record(
      out, file_names, field_names<dim>(), vectors_and_tensors<dim>(), flags);
  }



  template <int dim>
  typename BodyOutput<dim>::Patch
  BodyOutput<dim>::make_patch(
    const typename DoFHandler<dim>::active_cell_iterator &cell,
    const std::vector<PointResult>                       &points) const
  {
    using R = Rows<dim>;
    Patch patch;
    patch.n_subdivisions = degree;
    patch.reference_cell = ReferenceCells::get_hypercube<dim>();
    for (const unsigned int v : cell->vertex_indices())
      patch.vertices[v] = cell->vertex(v);
    patch.data.reinit(R::n, points.size());

    const auto    &fe = dof_handler.get_fe();
    Vector<double> values(fe.n_dofs_per_cell());
    cell->get_dof_values(ghosted_displacement, values);
    for (unsigned int i = 0; i < values.size(); ++i)
      {
        const auto [component, node] = fe.system_to_component_index(i);
        patch.data(R::displacement + component, to_lexicographic[node]) =
          values(i);
      }

    unsigned int n_plastic = 0;
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        const auto point_values = values_at<dim>(points[q]);
        for (unsigned int row = R::stress; row < R::plastic_fraction; ++row)
          for (unsigned int i = 0; i < points.size(); ++i)
            patch.data(row, i) += extrapolation(q, i) * point_values[row];
        if (points[q].plastic)
          ++n_plastic;
      }
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        for (const unsigned int row : {R::von_mises, R::alpha})
          patch.data(row, i) = std::max(patch.data(row, i), 0.f);
        patch.data(R::plastic_fraction, i) =
          static_cast<float>(n_plastic) / points.size();
        patch.data(R::error_indicator, i) =
          error_indicators(cell->active_cell_index());
        patch.data(R::material_id, i) = cell->material_id();
        patch.data(R::subdomain, i)   = cell->subdomain_id();
      }
    return patch;
  }



  template class BodyOutput<2>;
  template class BodyOutput<3>;
} // namespace ElastoPlastic
