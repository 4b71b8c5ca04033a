// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

#include "base/ghost_values.h"
#include "contact/contact_faces.h"
#include "contact/contact_nodes.h"
#include "mesh/boundary_faces.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The part of [0, 1] where the linear function with these values at the
    /// ends is negative.
    std::pair<double, double>
    negative_part(const double at_0, const double at_1)
    {
      if (at_0 < 0 && at_1 < 0)
        return {0., 1.};
      if (at_0 >= 0 && at_1 >= 0)
        return {0., 0.};
      const double root = at_0 / (at_0 - at_1);
      return at_0 < 0 ? std::make_pair(0., root) : std::make_pair(root, 1.);
    }



    /// How far from the edge, up to one element, a node with this @p gap is
    /// that grows by @p growth to the next node, if gaps grow like Hertz' with
    /// the power 3/2 of the way from the edge.
    double
    elements_from_edge(const double gap, const double growth)
    {
      if (gap <= 0.)
        return 0.;
      const double ratio =
        std::pow(gap / (gap + std::max(growth, 0.)), 2. / 3.);
      return ratio < 0.5 ? ratio / (1. - ratio) : 1.;
    }
  } // namespace



  template <int dim>
  void
  ContactFaces<dim>::reinit(const DoFHandler<dim>              &dof_handler,
                            const AffineConstraints<double>    &new_constraints,
                            const std::set<types::boundary_id> &boundaries,
                            const Kinematics                    new_kinematics,
                            const Vector                       &layout)
  {
    constraints   = &new_constraints;
    kinematics    = new_kinematics;
    vector_layout = layout.get_partitioner();

    const auto               &fe      = dof_handler.get_fe();
    const auto                lattice = lattice_of_face(fe);
    const unsigned int        p       = fe.degree;
    const Quadrature<dim - 1> nodes(
      fe.get_unit_face_support_points(),
      std::vector<double>(fe.n_dofs_per_face(),
                          1. / Utilities::fixed_power<dim - 1>(p)));
    FEFaceValues<dim>                    values(fe,
                             nodes,
                             update_quadrature_points | update_JxW_values);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_face());

    faces.clear();
    for (const auto &[cell, f] : owned_faces(dof_handler, boundaries))
      {
        values.reinit(cell, f);
        cell->face(f)->get_dof_indices(dofs);
        for (unsigned int j = 0; j < (dim == 3 ? p : 1); ++j)
          for (unsigned int i = 0; i < p; ++i)
            {
              Face face;
              for (unsigned int n = 0; n < n_nodes; ++n)
                {
                  const auto &node = lattice[i + n % 2 + (p + 1) * (j + n / 2)];
                  const unsigned int q = node[dim - 1];
                  face.dofs[n]         = dofs[q];
                  face.positions[n]    = values.quadrature_point(q);
                  for (unsigned int d = 0; d < dim - 1; ++d)
                    face.horizontal[n][d] = dofs[node[d]];
                  face.density[n] =
                    values.JxW(q) *
                    out_of_plane_length(values.quadrature_point(q), kinematics);
                }
              faces.push_back(face);
            }
      }
    find_areas();
  }



  template <int dim>
  void
  ContactFaces<dim>::find_areas()
  {
    std::array<double, n_nodes> below;
    below.fill(-1.);
    for (Face &face : faces)
      face.areas = integrate(face, below);
  }



  template <int dim>
  typename ContactFaces<dim>::Vector
  ContactFaces<dim>::areas() const
  {
    Vector result(vector_layout);
    for (const Face &face : faces)
      for (unsigned int n = 0; n < n_nodes; ++n)
        constraints->distribute_local_to_global(face.dofs[n],
                                                face.areas[n],
                                                result);
    result.compress(VectorOperation::add);
    return result;
  }



  template <int dim>
  std::vector<EdgeLaw::Pair>
  ContactFaces<dim>::neighbors() const
  {
    std::vector<EdgeLaw::Pair> pairs;
    for (const Face &face : faces)
      {
        std::set<types::global_dof_index> dofs;
        for (const auto dof : face.dofs)
          if (const auto *const masters =
                constraints->get_constraint_entries(dof))
            for (const auto &[master, weight] : *masters)
              dofs.insert(master);
          else
            dofs.insert(dof);
        for (const auto one : dofs)
          for (const auto other : dofs)
            if (one < other)
              pairs.emplace_back(one, other);
      }
    return pairs;
  }



  template <int dim>
  typename ContactFaces<dim>::Vector
  ContactFaces<dim>::levels(const Vector &kinds, const Vector &gaps) const
  {
    const GhostValues ghosts_of_kinds(kinds), ghosts_of_gaps(gaps);
    Vector            are_near(vector_layout), growth(vector_layout);
    for (const Face &face : faces)
      if (std::any_of(face.dofs.begin(), face.dofs.end(), [&](const auto dof) {
            return kinds(dof) == closed;
          }))
        for (const auto dof : face.dofs)
          if (kinds(dof) == not_closed)
            are_near(dof) = 1.;
    are_near.compress(VectorOperation::max);
    const GhostValues ghosts_of_near(are_near);
    for (const Face &face : faces)
      for (const auto near : face.dofs)
        if (are_near(near) == 1.)
          for (const auto far : face.dofs)
            if (kinds(far) == not_closed && are_near(far) == 0.)
              growth(near) =
                std::max<double>(growth(near), gaps(far) - gaps(near));
    growth.compress(VectorOperation::max);

    Vector result(vector_layout);
    for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
      result.local_element(i) =
        are_near.local_element(i) == 1. ?
          elements_from_edge(gaps.local_element(i), growth.local_element(i)) :
          1.;
    return result;
  }



  // The level of a closed node is as far below zero as the mean of the others
  // is below one: on a face of two nodes, the part 1 - level is touched.
  template <int dim>
  typename ContactFaces<dim>::Vector
  ContactFaces<dim>::touched_areas(const Vector &kinds,
                                   const Vector &levels) const
  {
    const Vector      whole = areas();
    const GhostValues ghosts_of_kinds(kinds), ghosts_of_levels(levels);
    Vector            result(vector_layout), has_closed_face(vector_layout);
    for (const Face &face : faces)
      {
        unsigned int n_others = 0, n_closed = 0;
        double       sum = 0;
        for (const auto dof : face.dofs)
          {
            n_others += (kinds(dof) == not_closed);
            n_closed += (kinds(dof) == closed);
            sum += (kinds(dof) == not_closed ? levels(dof) : 0.);
          }
        if (n_closed == n_nodes)
          for (const auto dof : face.dofs)
            has_closed_face(dof) = 1.;
        if (n_others == 0 || n_closed == 0 || n_others + n_closed < n_nodes)
          continue;

        std::array<double, n_nodes> level;
        for (unsigned int n = 0; n < n_nodes; ++n)
          level[n] = kinds(face.dofs[n]) == closed ? sum / n_others - 1. :
                                                     levels(face.dofs[n]);
        const auto touched = integrate(face, level);
        double     own = 0, all = 0;
        for (unsigned int n = 0; n < n_nodes; ++n)
          {
            own += kinds(face.dofs[n]) == closed ? touched[n] : 0.;
            all += touched[n];
          }
        for (unsigned int n = 0; n < n_nodes; ++n)
          if (kinds(face.dofs[n]) == closed)
            result(face.dofs[n]) +=
              (own > 0. ? touched[n] * all / own : 0.) - face.areas[n];
      }
    result.compress(VectorOperation::add);
    has_closed_face.compress(VectorOperation::max);
    for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
      result.local_element(i) =
        kinds.local_element(i) == closed ?
          whole.local_element(i) +
            has_closed_face.local_element(i) * result.local_element(i) :
          0.;
    return result;
  }



  template <>
  std::array<double, 2>
  ContactFaces<2>::projected_density(
    const std::array<Point<2>, 2> &positions) const
  {
    const double length = std::abs(positions[1][0] - positions[0][0]);
    return {{length * out_of_plane_length(positions[0], kinematics),
             length * out_of_plane_length(positions[1], kinematics)}};
  }



  template <>
  std::array<double, 4>
  ContactFaces<3>::projected_density(
    const std::array<Point<3>, 4> &positions) const
  {
    std::array<double, 4> density;
    for (unsigned int n = 0; n < 4; ++n)
      {
        const Tensor<1, 3> along_x = positions[n | 1] - positions[n & 2];
        const Tensor<1, 3> along_y = positions[n | 2] - positions[n & 1];
        density[n] = std::abs(cross_product_3d(along_x, along_y)[2]);
      }
    return density;
  }



  template <int dim>
  ContactFaces<dim>
  ContactFaces<dim>::moved(const Vector &u) const
  {
    ContactFaces      result = *this;
    const GhostValues ghosts_of_u(u);
    for (Face &face : result.faces)
      {
        for (unsigned int n = 0; n < n_nodes; ++n)
          for (unsigned int d = 0; d < dim - 1; ++d)
            face.positions[n][d] += u(face.horizontal[n][d]);
        face.density = projected_density(face.positions);
      }
    result.find_areas();
    return result;
  }



  template <>
  std::array<double, 2>
  ContactFaces<2>::integrate(const Face                  &face,
                             const std::array<double, 2> &levels)
  {
    const auto [begin, end] = negative_part(levels[0], levels[1]);
    const QGauss<1>       gauss(2); // exact
    std::array<double, 2> result = {{0., 0.}};
    for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        const double x = begin + (end - begin) * gauss.point(q)[0];
        const double weight =
          (end - begin) * gauss.weight(q) *
          ((1. - x) * face.density[0] + x * face.density[1]);
        result[0] += weight * (1. - x);
        result[1] += weight * x;
      }
    return result;
  }



  // Line by line, on each of which the level is linear; the mean of lines along
  // both directions.
  template <>
  std::array<double, 4>
  ContactFaces<3>::integrate(const Face                  &face,
                             const std::array<double, 4> &levels)
  {
    const QGauss<1>       gauss(2), lines(8);
    std::array<double, 4> result = {{0., 0., 0., 0.}};
    for (unsigned int direction = 0; direction < 2; ++direction)
      for (unsigned int l = 0; l < lines.size(); ++l)
        {
          const double y  = lines.point(l)[0];
          const auto   at = [&](const double x) {
            return direction == 0 ? Point<2>(x, y) : Point<2>(y, x);
          };
          const auto interpolate = [](const std::array<double, 4> &values,
                                      const Point<2>              &point) {
            double value = 0;
            for (unsigned int n = 0; n < 4; ++n)
              value +=
                values[n] * GeometryInfo<2>::d_linear_shape_function(point, n);
            return value;
          };
          const auto [begin, end] = negative_part(interpolate(levels, at(0.)),
                                                  interpolate(levels, at(1.)));
          for (unsigned int q = 0; q < gauss.size(); ++q)
            {
              const Point<2> x = at(begin + (end - begin) * gauss.point(q)[0]);
              const double   weight = 0.5 * lines.weight(l) * (end - begin) *
                                    gauss.weight(q) *
                                    interpolate(face.density, x);
              for (unsigned int n = 0; n < 4; ++n)
                result[n] +=
                  weight * GeometryInfo<2>::d_linear_shape_function(x, n);
            }
        }
    return result;
  }



  template class ContactFaces<2>;
  template class ContactFaces<3>;
} // namespace ElastoPlastic
