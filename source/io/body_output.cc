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



    /// Of cells, in the last rows of a patch's data.
    enum CellField
    {
      plastic_fraction,
      error_indicator,
      material_id,
      subdomain,
      n_cell_fields
    };



    unsigned int
    n_components(const std::vector<PointField> &fields)
    {
      unsigned int n = 0;
      for (const PointField &field : fields)
        n += field.n_components;
      return n;
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



    /// Compressed, with the units that have names.
    DataOutBase::VtkFlags
    make_flags(const std::vector<PointField> &fields, const Units &units)
    {
      DataOutBase::VtkFlags flags;
      flags.compression_level = DataOutBase::VtkFlags::best_speed;
      if (!units.length.empty())
        flags.physical_units["displacement"] = units.of("length");
      if (units.are_named())
        for (const PointField &field : fields)
          flags.physical_units[field.name] = units.of(field.quantity);
      return flags;
    }
  } // namespace



  template <int dim>
  BodyOutput<dim>::BodyOutput(const DoFHandler<dim>    &dof_handler,
                              const VectorType         &displacement,
                              const SolidOperator<dim> &solid,
                              const Vector<float>      &error_indicators,
                              const OutputParameters   &parameters)
    : dof_handler(dof_handler)
    , displacement(displacement)
    , solid(solid)
    , error_indicators(error_indicators)
    , fields(point_fields(parameters.additional_fields))
    , degree(dof_handler.get_fe().degree)
    , ghosted_displacement(ghosted_copy(displacement, dof_handler))
    , to_lexicographic(
        FETools::hierarchic_to_lexicographic_numbering<dim>(degree))
    , extrapolation(make_extrapolation<dim>(degree))
    , flags(make_flags(fields, parameters.units))
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
  std::vector<std::string>
  BodyOutput<dim>::row_names() const
  {
    std::vector<std::string> names(dim, "displacement");
    for (const PointField &field : fields)
      names.insert(names.end(), field.n_components, field.name);
    for (const auto *const name :
         {"plastic_fraction", "error_indicator", "material_id", "subdomain"})
      names.push_back(name);
    return names;
  }



  template <int dim>
  std::vector<typename BodyOutput<dim>::Range>
  BodyOutput<dim>::vectors_and_tensors() const
  {
    using namespace DataComponentInterpretation;
    std::vector<Range> ranges = {
      {0, dim - 1, "displacement", component_is_part_of_vector}};
    unsigned int row = dim;
    for (const PointField &field : fields)
      {
        const unsigned int next_row = row + field.n_components;
        if (field.n_components > 1)
          ranges.emplace_back(row,
                              next_row - 1,
                              field.name,
                              component_is_part_of_tensor);
        row = next_row;
      }
    return ranges;
  }



  template <int dim>
  void
  BodyOutput<dim>::write_vtu(std::ostream &out) const
  {
    std::vector<Patch> patches;
    const auto         write_piece = [&]() {
      DataOutBase::write_vtu_main(
        patches, row_names(), vectors_and_tensors(), flags, out);
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
      out, file_names, row_names(), vectors_and_tensors(), flags);
  }



  template <int dim>
  typename BodyOutput<dim>::Patch
  BodyOutput<dim>::make_patch(
    const typename DoFHandler<dim>::active_cell_iterator &cell,
    const std::vector<PointResult>                       &points) const
  {
    const unsigned int first_cell_field = dim + n_components(fields);
    Patch              patch;
    patch.n_subdivisions = degree;
    patch.reference_cell = ReferenceCells::get_hypercube<dim>();
    for (const unsigned int v : cell->vertex_indices())
      patch.vertices[v] = cell->vertex(v);
    patch.data.reinit(first_cell_field + n_cell_fields, points.size());

    const auto    &fe = dof_handler.get_fe();
    Vector<double> values(fe.n_dofs_per_cell());
    cell->get_dof_values(ghosted_displacement, values);
    for (unsigned int i = 0; i < values.size(); ++i)
      {
        const auto [component, node] = fe.system_to_component_index(i);
        patch.data(component, to_lexicographic[node]) = values(i);
      }

    extrapolate(points, dim, patch.data);

    const float share_of_plastic =
      static_cast<float>(
        std::count_if(points.begin(),
                      points.end(),
                      [](const PointResult &point) { return point.plastic; })) /
      points.size();
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        patch.data(first_cell_field + plastic_fraction, i) = share_of_plastic;
        patch.data(first_cell_field + error_indicator, i) =
          error_indicators(cell->active_cell_index());
        patch.data(first_cell_field + material_id, i) = cell->material_id();
        patch.data(first_cell_field + subdomain, i)   = cell->subdomain_id();
      }
    return patch;
  }



  template <int dim>
  void
  BodyOutput<dim>::extrapolate(const std::vector<PointResult> &points,
                               const unsigned int              first_row,
                               dealii::Table<2, float>        &data) const
  {
    unsigned int row = first_row;
    for (const PointField &field : fields)
      {
        std::vector<float> values(field.n_components);
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            field.evaluate(points[q], values.data());
            for (unsigned int c = 0; c < values.size(); ++c)
              for (unsigned int i = 0; i < points.size(); ++i)
                data(row + c, i) += extrapolation(q, i) * values[c];
          }
        if (field.is_positive)
          for (unsigned int i = 0; i < points.size(); ++i)
            data(row, i) = std::max(data(row, i), 0.f);
        row += values.size();
      }
  }



  template class BodyOutput<2>;
  template class BodyOutput<3>;
} // namespace ElastoPlastic
