// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <numeric>

#include "base/ghost_values.h"
#include "contact/contact_nodes.h"
#include "contact/face_filter.h"
#include "mesh/boundary_faces.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The values of the (bi)linear shape functions at the nodes of the
    /// lattice.
    template <int face_dim>
    std::vector<std::vector<double>>
    linear_functions_on_lattice(const unsigned int degree)
    {
      const unsigned int n_nodes = Utilities::pow(degree + 1, face_dim);
      std::vector<std::vector<double>> values(n_nodes);
      for (unsigned int n = 0; n < n_nodes; ++n)
        {
          Point<face_dim> x;
          for (unsigned int d = 0, rest = n; d < face_dim;
               ++d, rest /= degree + 1)
            x[d] = double(rest % (degree + 1)) / degree;
          for (unsigned int v = 0; v < (1U << face_dim); ++v)
            values[n].push_back(
              GeometryInfo<face_dim>::d_linear_shape_function(x, v));
        }
      return values;
    }
  } // namespace



  template <int dim>
  void
  FaceFilter<dim>::reinit(const DoFHandler<dim>              &dof_handler,
                          const AffineConstraints<double>    &new_constraints,
                          const std::set<types::boundary_id> &boundaries,
                          const Kinematics                    kinematics,
                          const Vector                       &layout)
  {
    constraints   = &new_constraints;
    vector_layout = layout.get_partitioner();
    faces.clear();
    const auto &fe = dof_handler.get_fe();
    if (fe.degree == 1)
      return;

    linear_functions = linear_functions_on_lattice<dim - 1>(fe.degree);
    const auto                           lattice = lattice_of_face(fe);
    const QGauss<dim - 1>                quadrature(fe.degree + 1);
    FEFaceValues<dim>                    values(fe,
                             quadrature,
                             update_values | update_JxW_values |
                               update_quadrature_points);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_face());
    for (const auto &[cell, f] : owned_faces(dof_handler, boundaries))
      {
        values.reinit(cell, f);
        cell->face(f)->get_dof_indices(dofs);
        Face face;
        for (const auto &node : lattice)
          {
            for (const unsigned int i : node)
              face.dofs.push_back(dofs[i]);
            double area = 0;
            for (const unsigned int q : values.quadrature_point_indices())
              area +=
                values.shape_value(fe.face_to_cell_index(node[dim - 1], f), q) *
                values.JxW(q) *
                out_of_plane_length(values.quadrature_point(q), kinematics);
            face.areas.push_back(area);
          }
        faces.push_back(face);
      }
  }



  template <int dim>
  bool
  FaceFilter<dim>::is_touched(const Face &face, const Vector &touched) const
  {
    const double no_area = // rounding
      1e-12 * *std::max_element(face.areas.begin(), face.areas.end());
    for (unsigned int n = 0; n < face.areas.size(); ++n)
      if (face.areas[n] > no_area &&
          touched(face.dofs[n * dim + dim - 1]) < 1. - 1e-12)
        return false;
    return true;
  }



  template <int dim>
  std::vector<double>
  FaceFilter<dim>::filtered(const Face                &face,
                            const std::vector<double> &values) const
  {
    const unsigned int     n_functions = linear_functions[0].size();
    FullMatrix<double>     mass(n_functions, n_functions);
    dealii::Vector<double> moments(n_functions), solution(n_functions);
    for (unsigned int n = 0; n < values.size(); ++n)
      for (unsigned int i = 0; i < n_functions; ++i)
        {
          const double weight = face.areas[n] * linear_functions[n][i];
          moments(i) += weight * values[n];
          for (unsigned int j = 0; j < n_functions; ++j)
            mass(i, j) += weight * linear_functions[n][j];
        }
    mass.gauss_jordan();
    mass.vmult(solution, moments);

    std::vector<double> result(values.size());
    for (unsigned int n = 0; n < values.size(); ++n)
      for (unsigned int i = 0; i < n_functions; ++i)
        result[n] += linear_functions[n][i] * solution(i);
    return result;
  }



  template <int dim>
  void
  FaceFilter<dim>::apply(Vector &values, const Vector &touched) const
  {
    if (linear_functions.empty())
      return;
    constraints->distribute(values);
    Vector everywhere = touched;
    constraints->distribute(everywhere);
    Vector sums(vector_layout), areas(vector_layout);
    {
      const GhostValues ghosts_of_values(values), ghosts_of_touched(everywhere);
      std::vector<double> of_nodes;
      for (const Face &face : faces)
        {
          if (!is_touched(face, everywhere))
            continue;
          const double area =
            std::accumulate(face.areas.begin(), face.areas.end(), 0.);
          for (unsigned int d = 0; d < dim; ++d)
            {
              of_nodes.clear();
              for (unsigned int n = 0; n < face.areas.size(); ++n)
                of_nodes.push_back(values(face.dofs[n * dim + d]));
              of_nodes = filtered(face, of_nodes);
              for (unsigned int n = 0; n < face.areas.size(); ++n)
                {
                  sums(face.dofs[n * dim + d]) += area * of_nodes[n];
                  areas(face.dofs[n * dim + d]) += area;
                }
            }
        }
    }
    sums.compress(VectorOperation::add);
    areas.compress(VectorOperation::add);
    for (unsigned int i = 0; i < sums.locally_owned_size(); ++i)
      if (areas.local_element(i) > 0.)
        values.local_element(i) =
          sums.local_element(i) / areas.local_element(i);
    constraints->set_zero(values);
  }



  template class FaceFilter<2>;
  template class FaceFilter<3>;
} // namespace ElastoPlastic
