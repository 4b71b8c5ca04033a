// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/qprojector.h>
#include <deal.II/fe/fe.h>

#include <cmath>

#include "adaptivity/kelly_estimator.h"
#include "base/compatibility.h"
#include "base/ghost_values.h"

namespace ElastoPlastic
{
  namespace
  {
    template <int dim, std::size_t n_vertices>
    bool
    is_parallelepiped(const std::array<Point<dim>, n_vertices> &vertices)
    {
      for (unsigned int v = 0; v < n_vertices; ++v)
        {
          Tensor<1, dim> deviation = vertices[v] - vertices[0];
          for (unsigned int d = 0; d < dim; ++d)
            if ((v >> d) % 2 == 1)
              deviation -= vertices[1U << d] - vertices[0];
          if (deviation.norm_square() >
              1e-24 * (vertices[n_vertices - 1] - vertices[0]).norm_square())
            return false;
        }
      return true;
    }
  } // namespace



  template <int dim>
  KellyEstimator<dim>::KellyEstimator(const FiniteElement<dim> &fe)
    : quadrature(fe.degree + 1)
  {
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      {
        const auto [component, node] = fe.system_to_component_index(i);
        shape_functions.emplace_back(node, component);
      }

    const FiniteElement<dim> &scalar_fe = fe.base_element(0);
    const auto                hypercube = ReferenceCells::get_hypercube<dim>();
    const auto tabulate = [&](const std::vector<Point<dim>> &points) {
      for (const Point<dim> &point : points)
        {
          node_gradients.emplace_back();
          for (unsigned int i = 0; i < scalar_fe.n_dofs_per_cell(); ++i)
            node_gradients.back().push_back(scalar_fe.shape_grad(i, point));
          vertex_gradients.emplace_back();
          for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
            vertex_gradients.back().push_back(
              GeometryInfo<dim>::d_linear_shape_function_gradient(point, v));
        }
    };
    tabulate(QProjector<dim>::project_to_all_faces(hypercube, quadrature)
               .get_points());
    first_subface_point = node_gradients.size();
    tabulate(QProjector<dim>::project_to_all_subfaces(hypercube, quadrature)
               .get_points());
  }



  template <int dim>
  unsigned int
  KellyEstimator<dim>::first_point(const Side &side) const
  {
    using Points = typename QProjector<dim>::DataSetDescriptor;
    const auto &[cell, face, subface] = side;
    const auto hypercube              = ReferenceCells::get_hypercube<dim>();
    return with_face_orientation(
      cell,
      face,
      [&, f = face, sf = subface](const auto... orientation) -> unsigned int {
        if (sf == whole_face)
          return Points::face(hypercube, f, orientation..., quadrature.size());
        return first_subface_point + Points::subface(hypercube,
                                                     f,
                                                     sf,
                                                     orientation...,
                                                     quadrature.size());
      });
  }



  // Each is seen by the finer of its cells, or by the first one if both are
  // alike; but by that of this rank if another one owns the first.
  template <int dim>
  template <typename Use>
  void
  KellyEstimator<dim>::for_each_face(const DoFHandler<dim> &dof_handler,
                                     const Use             &use) const
  {
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->is_locally_owned() || cell->at_boundary(f))
            continue;
          const auto neighbor = cell->neighbor(f);
          if (cell->neighbor_is_coarser(f))
            {
              const auto [face, part] = cell->neighbor_of_coarser_neighbor(f);
              use({cell, f}, {neighbor, face, static_cast<int>(part)});
            }
          else if (neighbor->is_active())
            {
              if (!neighbor->is_locally_owned() || cell < neighbor)
                use({cell, f}, {neighbor, cell->neighbor_of_neighbor(f)});
            }
          else
            for (unsigned int part = 0; part < cell->face(f)->n_children();
                 ++part)
              if (const Cell child = cell->neighbor_child_on_subface(f, part);
                  !child->is_locally_owned())
                use({child, cell->neighbor_of_neighbor(f)},
                    {cell, f, static_cast<int>(part)});
        }
  }



  template <int dim>
  void
  KellyEstimator<dim>::read(const Cell   &cell,
                            const Vector &ghosted_u,
                            SideField    &field) const
  {
    field.cell = cell;
    for (const unsigned int v : cell->vertex_indices())
      field.vertices[v] = cell->vertex(v);
    field.is_parallelepiped = is_parallelepiped(field.vertices);

    field.dof_values.reinit(shape_functions.size(), true);
    cell->get_dof_values(ghosted_u, field.dof_values);
    field.values.resize(shape_functions.size() / dim);
    for (unsigned int i = 0; i < shape_functions.size(); ++i)
      {
        const auto &[node, component] = shape_functions[i];
        field.values[node][component] = field.dof_values(i);
      }
  }



  // With the Jacobian J of the mapping and the normal N of the reference cell,
  // n is J^-T N over its length, and du/dn is the derivative of u on the
  // reference cell in the direction J^-1 n.
  template <int dim>
  void
  KellyEstimator<dim>::evaluate(const Side   &side,
                                const Vector &ghosted_u,
                                SideField    &field) const
  {
    if (field.values.empty() || field.cell != side.cell)
      read(side.cell, ghosted_u, field);
    field.normal_derivatives.assign(quadrature.size(), Tensor<1, dim>());
    field.areas.resize(quadrature.size());

    const Tensor<1, dim> reference_normal =
      GeometryInfo<dim>::unit_normal_vector[side.face];
    const unsigned int begin = first_point(side);
    Tensor<1, dim>     direction;
    double             area = 0;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        if (q == 0 || !field.is_parallelepiped)
          {
            Tensor<2, dim> jacobian;
            for (unsigned int v = 0; v < field.vertices.size(); ++v)
              jacobian += outer_product(field.vertices[v],
                                        vertex_gradients[begin + q][v]);
            const Tensor<2, dim> inverse = invert(jacobian);
            const Tensor<1, dim> normal  = reference_normal * inverse;
            const double         length  = normal.norm();

            direction = inverse * (normal / length);
            area      = std::abs(determinant(jacobian)) * length;
          }
        field.areas[q] = area * quadrature.weight(q);
        for (unsigned int i = 0; i < field.values.size(); ++i)
          field.normal_derivatives[q] +=
            (node_gradients[begin + q][i] * direction) * field.values[i];
      }
  }



  template <int dim>
  dealii::Vector<float>
  KellyEstimator<dim>::estimate(const DoFHandler<dim> &dof_handler,
                                const Vector          &u) const
  {
    const Vector ghosted_u = ghosted_copy(u, dof_handler);
    std::vector<std::array<double, GeometryInfo<dim>::faces_per_cell>>
              integrals(dof_handler.get_triangulation().n_active_cells());
    SideField field, other_field;
    for_each_face(dof_handler, [&](const Side &side, const Side &other) {
      evaluate(side, ghosted_u, field);
      evaluate(other, ghosted_u, other_field);
      double integral = 0;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        integral += field.areas[q] * (field.normal_derivatives[q] +
                                      other_field.normal_derivatives[q])
                                       .norm_square();
      for (const auto &[cell, face, part] : {side, other})
        integrals[cell->active_cell_index()][face] += integral;
    });

    // Summed up in single precision, face by face, as deal.II does: cells that
    // symmetry makes equal are told apart by rounding only, and shall be
    // marked alike.
    dealii::Vector<float> estimates(integrals.size());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          float       &estimate = estimates(cell->active_cell_index());
          const double factor   = cell->diameter() / 24.;
          for (const double integral : integrals[cell->active_cell_index()])
            estimate += factor * integral;
          estimate = std::sqrt(estimate);
        }
    return estimates;
  }



  template class KellyEstimator<2>;
  template class KellyEstimator<3>;
} // namespace ElastoPlastic
