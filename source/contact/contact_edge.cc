// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <algorithm>
#include <cmath>

#include "contact/contact_edge.h"

namespace ElastoPlastic
{
  namespace
  {
    /// The indices of the vertical unknowns of a face of FE_Q(p)^dim in
    /// get_dof_indices(), by their place in the lattice of (p + 1)^(dim-1)
    /// nodes.
    template <int dim>
    std::vector<unsigned int>
    vertical_lattice(const FiniteElement<dim> &fe)
    {
      const unsigned int        n      = fe.degree + 1;
      const auto               &points = fe.get_unit_face_support_points();
      std::vector<unsigned int> lattice(Utilities::fixed_power<dim - 1>(n));
      for (unsigned int i = 0; i < points.size(); ++i)
        if (fe.face_system_to_component_index(i).first == dim - 1)
          {
            unsigned int place = 0;
            for (unsigned int d = dim - 1; d-- > 0;)
              place = n * place + std::lround(points[i][d] * fe.degree);
            lattice[place] = i;
          }
      return lattice;
    }



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



    /// For each node, with the @p owned partition, the largest of the @p values
    /// that its owner and other ranks have set, not negative.
    template <typename Vector, typename Partitioner>
    Vector
    largest_of_all_ranks(Vector &values, const Partitioner &owned)
    {
      values.compress(VectorOperation::max);
      Vector result(owned);
      result.copy_locally_owned_data_from(values);
      return result;
    }
  } // namespace



  void
  ContactParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Contact");
    prm.add_parameter(
      "Edge",
      edge,
      "Where the contact ends. at nodes: one node after the other comes into "
      "contact; each makes the force jump where the body flows plastically, and "
      "the contact area counts whole nodes. within faces: in a load history its "
      "edge moves through the faces of the mesh, and force and contact area "
      "change smoothly with the depth.");
    prm.leave_subsection();
  }



  template <int dim>
  void
  ContactEdge<dim>::reinit(const DoFHandler<dim>              &dof_handler,
                           const AffineConstraints<double>    &constraints,
                           const std::set<types::boundary_id> &boundaries,
                           const Kinematics                    kinematics,
                           const Vector                       &layout)
  {
    IndexSet relevant;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    vectors         = layout.get_partitioner();
    ghosted_vectors = std::make_shared<Utilities::MPI::Partitioner>(
      dof_handler.locally_owned_dofs(),
      relevant,
      layout.get_mpi_communicator());

    const auto               &fe      = dof_handler.get_fe();
    const auto                lattice = vertical_lattice(fe);
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
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          {
            if (!cell->face(f)->at_boundary() ||
                boundaries.count(cell->face(f)->boundary_id()) == 0)
              continue;
            values.reinit(cell, f);
            cell->face(f)->get_dof_indices(dofs);
            for (unsigned int j = 0; j < (dim == 3 ? p : 1); ++j)
              for (unsigned int i = 0; i < p; ++i)
                {
                  Face face;
                  for (unsigned int n = 0; n < n_nodes; ++n)
                    {
                      const unsigned int q =
                        lattice[i + n % 2 + (p + 1) * (j + n / 2)];
                      face.dofs[n] = dofs[q];
                      face.density[n] =
                        values.JxW(q) *
                        extent(values.quadrature_point(q), kinematics);
                    }
                  faces.push_back(face);
                }
          }
    find_areas(constraints);
  }



  template <int dim>
  void
  ContactEdge<dim>::find_areas(const AffineConstraints<double> &constraints)
  {
    Vector                      areas(ghosted_vectors);
    std::array<double, n_nodes> below;
    below.fill(-1.);
    for (const Face &face : faces)
      {
        const auto whole = integrate(face, below);
        for (unsigned int n = 0; n < n_nodes; ++n)
          constraints.distribute_local_to_global(face.dofs[n], whole[n], areas);
      }
    areas.compress(VectorOperation::add);
    whole_areas.reinit(vectors);
    whole_areas.copy_locally_owned_data_from(areas);
  }



  template <>
  std::array<double, 2>
  ContactEdge<2>::integrate(const Face                  &face,
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
  ContactEdge<3>::integrate(const Face                  &face,
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



  template <int dim>
  typename ContactEdge<dim>::Vector
  ContactEdge<dim>::ghosted(const Vector &vector) const
  {
    Vector copy(ghosted_vectors);
    copy.copy_locally_owned_data_from(vector);
    copy.update_ghost_values();
    return copy;
  }



  // The level of a touching node is as far below zero as the mean of the open
  // ones is below one: on a face of two nodes, the part 1 - level is touched.
  template <int dim>
  typename ContactEdge<dim>::TouchedPart
  ContactEdge<dim>::touched_part(const Vector &kinds,
                                 const Vector &levels) const
  {
    const Vector   kind_of = ghosted(kinds), level_of = ghosted(levels);
    const IndexSet owned        = ghosted_vectors->locally_owned_range();
    const MPI_Comm communicator = ghosted_vectors->get_mpi_communicator();
    IndexSet       relevant     = owned;
    relevant.add_indices(ghosted_vectors->ghost_indices());
    TrilinosWrappers::SparsityPattern pattern(owned,
                                              owned,
                                              relevant,
                                              communicator);

    Vector                      missing(ghosted_vectors);
    std::array<double, n_nodes> below;
    below.fill(-1.);
    struct Entry
    {
      types::global_dof_index row, column;
      double                  value;
    };
    std::vector<Entry> entries;
    for (const Face &face : faces)
      {
        unsigned int n_open = 0, n_touching = 0;
        double       sum = 0;
        for (const auto dof : face.dofs)
          {
            n_open += (kind_of(dof) == open);
            n_touching += (kind_of(dof) == touching);
            sum += (kind_of(dof) == open ? level_of(dof) : 0.);
          }
        if (n_open == 0 || n_touching == 0 || n_open + n_touching < n_nodes)
          continue;

        std::array<double, n_nodes> level;
        for (unsigned int n = 0; n < n_nodes; ++n)
          level[n] = kind_of(face.dofs[n]) == open ? level_of(face.dofs[n]) :
                                                     sum / n_open - 1.;
        const auto touched = integrate(face, level);
        const auto whole   = integrate(face, below);
        double     own     = 0;
        for (unsigned int n = 0; n < n_nodes; ++n)
          if (kind_of(face.dofs[n]) == touching)
            {
              missing(face.dofs[n]) += whole[n] - touched[n];
              own += touched[n];
            }
        if (own > 0.)
          for (unsigned int n = 0; n < n_nodes; ++n)
            for (unsigned int m = 0; m < n_nodes; ++m)
              if (kind_of(face.dofs[n]) == touching &&
                  kind_of(face.dofs[m]) == open)
                entries.push_back(
                  {face.dofs[n], face.dofs[m], touched[m] * touched[n] / own});
      }
    missing.compress(VectorOperation::add);

    for (const Entry &entry : entries)
      pattern.add(entry.row, entry.column);
    pattern.compress();
    TouchedPart result;
    result.missing.reinit(vectors);
    result.missing.copy_locally_owned_data_from(missing);
    result.taken_over = std::make_shared<Matrix>(pattern);
    for (const Entry &entry : entries)
      result.taken_over->add(entry.row, entry.column, entry.value);
    result.taken_over->compress(VectorOperation::add);
    return result;
  }



  template <int dim>
  typename ContactEdge<dim>::Vector
  ContactEdge<dim>::neighbors(const Vector &kinds) const
  {
    const Vector kind_of = ghosted(kinds);
    Vector       marks(ghosted_vectors);
    for (const Face &face : faces)
      if (std::any_of(face.dofs.begin(), face.dofs.end(), [&](const auto dof) {
            return kind_of(dof) == touching;
          }))
        for (const auto dof : face.dofs)
          if (kind_of(dof) == open)
            marks(dof) = 1.;
    return largest_of_all_ranks(marks, vectors);
  }



  template <int dim>
  typename ContactEdge<dim>::Vector
  ContactEdge<dim>::inside(const Vector &kinds) const
  {
    const Vector kind_of = ghosted(kinds);
    Vector       marks(ghosted_vectors);
    for (const Face &face : faces)
      if (std::all_of(face.dofs.begin(), face.dofs.end(), [&](const auto dof) {
            return kind_of(dof) == touching;
          }))
        for (const auto dof : face.dofs)
          marks(dof) = 1.;
    return largest_of_all_ranks(marks, vectors);
  }



  template <int dim>
  typename ContactEdge<dim>::Vector
  ContactEdge<dim>::growth_beyond(const Vector &kinds,
                                  const Vector &neighbors,
                                  const Vector &values) const
  {
    const Vector kind_of = ghosted(kinds), value_of = ghosted(values);
    const Vector is_neighbor = ghosted(neighbors);
    Vector       growth(ghosted_vectors);
    for (const Face &face : faces)
      for (const auto near : face.dofs)
        if (is_neighbor(near) == 1.)
          for (const auto far : face.dofs)
            if (kind_of(far) == open && is_neighbor(far) == 0.)
              for (const auto dof : {near, far})
                growth(dof) =
                  std::max<double>(growth(dof), value_of(far) - value_of(near));
    return largest_of_all_ranks(growth, vectors);
  }



  template class ContactEdge<2>;
  template class ContactEdge<3>;
} // namespace ElastoPlastic
