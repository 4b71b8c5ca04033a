// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>

#include "base/ghost_values.h"
#include "output/body_output.h"

namespace ElastoPlastic
{
  namespace
  {
    constexpr unsigned int cells_per_piece = 2000;



    /// The points of a grid of degree^dim cells on the reference cell.
    template <int dim>
    std::vector<Point<dim>>
    make_points(const unsigned int degree)
    {
      return QIterated<dim>(QTrapezoid<1>(), degree).get_points();
    }



    template <int dim>
    FullMatrix<float>
    make_extrapolation(const unsigned int degree)
    {
      const FE_DGQArbitraryNodes<dim> point_space(QGauss<1>(degree + 1));
      const std::vector<Point<dim>>   points   = make_points<dim>(degree);
      const unsigned int              n_points = points.size();
      FullMatrix<float>               extrapolation(n_points, n_points);
      for (unsigned int q = 0; q < n_points; ++q)
        for (unsigned int i = 0; i < n_points; ++i)
          extrapolation(q, i) = point_space.shape_value(q, points[i]);
      return extrapolation;
    }



    /// The corners of cell @p cell of a grid of @p degree^dim cells, as numbers
    /// of its points and in VTK's order.
    template <int dim>
    std::vector<unsigned int>
    corners(const unsigned int cell, const unsigned int degree)
    {
      constexpr std::array<unsigned int, 8> vtk_order = {
        {0, 1, 3, 2, 4, 5, 7, 6}};
      std::vector<unsigned int> points;
      for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
        {
          unsigned int point = 0, rest = cell, stride = 1;
          for (unsigned int d = 0; d < dim; ++d)
            {
              point += (rest % degree + (vtk_order[v] >> d) % 2) * stride;
              rest /= degree;
              stride *= degree + 1;
            }
          points.push_back(point);
        }
      return points;
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
    , units(parameters.units)
    , fields(
        point_fields(parameters.additional_fields, solid.is_rate_dependent()))
    , degree(dof_handler.get_fe().degree)
    , ghosted_displacement(ghosted_copy(displacement, dof_handler))
    , to_lexicographic(
        FETools::hierarchic_to_lexicographic_numbering<dim>(degree))
    , reference_points(make_points<dim>(degree))
    , extrapolation(make_extrapolation<dim>(degree))
  {}



  template <int dim>
  unsigned int
  BodyOutput<dim>::n_cells() const
  {
    const auto &mesh = dynamic_cast<const parallel::TriangulationBase<dim> &>(
      dof_handler.get_triangulation());
    return mesh.n_locally_owned_active_cells();
  }



  template <int dim>
  std::vector<AppendedVtu::Field>
  BodyOutput<dim>::vtu_fields() const
  {
    std::vector<AppendedVtu::Field> result = {
      {"displacement", 3, units.length.empty() ? "" : units.of("length")}};
    for (const PointField &field : fields)
      result.push_back({field.name,
                        field.n_components,
                        units.are_named() ? units.of(field.quantity) : ""});
    for (const auto *const name :
         {"plastic_fraction", "error_indicator", "material_id", "subdomain"})
      result.push_back({name, 1, ""});
    return result;
  }



  template <int dim>
  AppendedVtu::Piece
  BodyOutput<dim>::make_piece(const unsigned int n_cells) const
  {
    constexpr unsigned char vtk_quad = 9, vtk_hexahedron = 12;
    const unsigned int      n_subcells = Utilities::fixed_power<dim>(degree);

    const std::size_t  n_points = n_cells * reference_points.size();
    AppendedVtu::Piece piece;
    piece.points.reserve(3 * n_points);
    for (const AppendedVtu::Field &field : vtu_fields())
      {
        piece.fields.emplace_back();
        piece.fields.back().reserve(field.n_components * n_points);
      }
    piece.types.assign(n_cells * n_subcells,
                       dim == 2 ? vtk_quad : vtk_hexahedron);
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      for (unsigned int subcell = 0; subcell < n_subcells; ++subcell)
        {
          for (const unsigned int point : corners<dim>(subcell, degree))
            piece.connectivity.push_back(cell * reference_points.size() +
                                         point);
          piece.offsets.push_back(piece.connectivity.size());
        }
    return piece;
  }



  template <int dim>
  void
  BodyOutput<dim>::write_vtu(std::ostream &out) const
  {
    const auto n_points = static_cast<unsigned int>(reference_points.size());
    std::vector<unsigned int> sizes(n_cells() / cells_per_piece,
                                    cells_per_piece);
    if (const unsigned int rest = n_cells() % cells_per_piece; rest > 0)
      sizes.push_back(rest);
    std::vector<AppendedVtu::PieceSize> vtu_sizes;
    for (const unsigned int size : sizes)
      vtu_sizes.push_back(
        {size * n_points, size * Utilities::fixed_power<dim>(degree)});

    AppendedVtu        file(out, vtu_fields(), vtu_sizes);
    AppendedVtu::Piece piece;
    auto               size = sizes.begin();
    solid.for_each_cell(displacement,
                        [&](const auto &cell, const auto &points) {
                          if (piece.points.empty())
                            piece = make_piece(*size);
                          add_cell(cell, points, piece);
                          if (piece.points.size() == 3 * n_points * *size)
                            {
                              file.write(piece);
                              piece = {};
                              ++size;
                            }
                        });
    file.finish();
  }



  template <int dim>
  void
  BodyOutput<dim>::write_pvtu_record(
    std::ostream &out, const std::vector<std::string> &file_names) const
  {
    AppendedVtu::write_index(out, vtu_fields(), file_names);
  }



  template <int dim>
  void
  BodyOutput<dim>::add_cell(
    const typename DoFHandler<dim>::active_cell_iterator &cell,
    const std::vector<PointResult>                       &points,
    AppendedVtu::Piece                                   &piece) const
  {
    add_points(cell, piece.points);
    auto numbers = piece.fields.begin();
    add_displacement(cell, *numbers++);
    add_extrapolated(points, &*numbers);
    numbers += fields.size();

    const float n_plastic =
      std::count_if(points.begin(), points.end(), [](const PointResult &point) {
        return point.plastic;
      });
    for (const float value : {n_plastic / points.size(),
                              error_indicators(cell->active_cell_index()),
                              static_cast<float>(cell->material_id()),
                              static_cast<float>(cell->subdomain_id())})
      {
        numbers->insert(numbers->end(), reference_points.size(), value);
        ++numbers;
      }
  }



  template <int dim>
  void
  BodyOutput<dim>::add_points(
    const typename DoFHandler<dim>::active_cell_iterator &cell,
    std::vector<float>                                   &numbers) const
  {
    std::array<Point<dim>, GeometryInfo<dim>::vertices_per_cell> vertices;
    for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
      vertices[v] = cell->vertex(v);
    for (const Point<dim> &reference_point : reference_points)
      {
        Tensor<1, 3> point;
        for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
          for (unsigned int d = 0; d < dim; ++d)
            point[d] +=
              GeometryInfo<dim>::d_linear_shape_function(reference_point, v) *
              vertices[v][d];
        numbers.insert(numbers.end(), &point[0], &point[0] + 3);
      }
  }



  template <int dim>
  void
  BodyOutput<dim>::add_displacement(
    const typename DoFHandler<dim>::active_cell_iterator &cell,
    std::vector<float>                                   &numbers) const
  {
    const auto    &fe = dof_handler.get_fe();
    Vector<double> values(fe.n_dofs_per_cell());
    cell->get_dof_values(ghosted_displacement, values);
    const std::size_t begin = numbers.size();
    numbers.resize(begin + 3 * reference_points.size(), 0.f);
    for (unsigned int i = 0; i < values.size(); ++i)
      {
        const auto [component, node] = fe.system_to_component_index(i);
        numbers[begin + 3 * to_lexicographic[node] + component] = values(i);
      }
  }



  // All fields in one product with the matrix.
  template <int dim>
  void
  BodyOutput<dim>::add_extrapolated(const std::vector<PointResult> &points,
                                    std::vector<float> *const numbers) const
  {
    unsigned int n_components = 0;
    for (const PointField &field : fields)
      n_components += field.n_components;
    std::vector<float> values(n_components * points.size());
    auto              *value = values.data();
    for (const PointResult &point : points)
      for (const PointField &field : fields)
        {
          field.evaluate(point, value);
          value += field.n_components;
        }

    std::vector<float> sums(n_components);
    for (unsigned int i = 0; i < reference_points.size(); ++i)
      {
        std::fill(sums.begin(), sums.end(), 0.f);
        for (unsigned int q = 0; q < points.size(); ++q)
          for (unsigned int c = 0; c < n_components; ++c)
            sums[c] += extrapolation(q, i) * values[q * n_components + c];
        auto sum = sums.begin();
        for (unsigned int f = 0; f < fields.size(); ++f)
          for (unsigned int c = 0; c < fields[f].n_components; ++c, ++sum)
            numbers[f].push_back(fields[f].is_positive ? std::max(*sum, 0.f) :
                                                         *sum);
      }
  }



  template class BodyOutput<2>;
  template class BodyOutput<3>;
} // namespace ElastoPlastic
