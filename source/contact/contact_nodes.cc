// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <map>

#include "base/exceptions.h"
#include "contact/contact_nodes.h"
#include "mesh/boundary_faces.h"

namespace ElastoPlastic
{
  namespace
  {
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// The lumped boundary mass D of the vertical component, condensed: the
    /// integrals of the shape functions.
    template <int dim>
    void
    compute_lumped_areas(const DoFHandler<dim>              &dof_handler,
                         const AffineConstraints<double>    &constraints,
                         const std::set<types::boundary_id> &boundaries,
                         const Kinematics                    kinematics,
                         Vector                             &areas)
    {
      const auto                          &fe = dof_handler.get_fe();
      const QGauss<dim - 1>                quadrature(fe.degree + 1);
      FEFaceValues<dim>                    fe_face_values(fe,
                                       quadrature,
                                       update_values | update_JxW_values |
                                         update_quadrature_points);
      dealii::Vector<double>               cell_areas(fe.n_dofs_per_cell());
      std::vector<types::global_dof_index> dof_indices(fe.n_dofs_per_cell());

      for (const auto &[cell, f] : owned_faces(dof_handler, boundaries))
        {
          fe_face_values.reinit(cell, f);
          cell_areas = 0;
          for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
            if (fe.system_to_component_index(i).first == dim - 1)
              for (const unsigned int q :
                   fe_face_values.quadrature_point_indices())
                cell_areas(i) +=
                  fe_face_values.shape_value(i, q) * fe_face_values.JxW(q) *
                  out_of_plane_length(fe_face_values.quadrature_point(q),
                                      kinematics);
          cell->get_dof_indices(dof_indices);
          constraints.distribute_local_to_global(cell_areas,
                                                 dof_indices,
                                                 areas);
        }
      areas.compress(VectorOperation::add);
    }



    /// The nodes on @p boundaries whose vertical unknowns this rank owns, in
    /// their order, with what does not depend on other nodes.
    template <int dim>
    std::map<types::global_dof_index, ContactNode<dim>>
    find_nodes(
      const DoFHandler<dim>              &dof_handler,
      const std::set<types::boundary_id> &boundaries,
      const std::function<IndenterSurface<dim>(const Point<dim> &)> &gap,
      const Utilities::MPI::Partitioner &partitioner)
    {
      const auto               &fe = dof_handler.get_fe();
      const Quadrature<dim - 1> points(fe.get_unit_face_support_points());
      FEFaceValues<dim> fe_face_values(fe, points, update_quadrature_points);
      std::vector<types::global_dof_index> dof_indices(fe.n_dofs_per_face());
      const auto                           components = nodes_of_face(fe);

      std::map<types::global_dof_index, ContactNode<dim>> nodes;
      // A node's owner need not own one of its contact faces: look at ghosts
      // too.
      for (const auto &[cell, f] : known_faces(dof_handler, boundaries))
        {
          fe_face_values.reinit(cell, f);
          cell->face(f)->get_dof_indices(dof_indices);
          for (const auto &of_node : components)
            {
              const auto dof = dof_indices[of_node[dim - 1]];
              if (!partitioner.in_local_range(dof) || nodes.count(dof) > 0)
                continue;
              ContactNode<dim> &node = nodes[dof];
              node.index             = partitioner.global_to_local(dof);
              for (unsigned int d = 0; d < dim - 1; ++d)
                node.horizontal[d] =
                  partitioner.global_to_local(dof_indices[of_node[d]]);
              node.position = fe_face_values.quadrature_point(of_node[dim - 1]);
              node.gap      = gap(node.position);
            }
        }
      return nodes;
    }



    template <int dim>
    Tensor<2, dim - 1>
    find_ties(const ContactNode<dim>            &node,
              const AffineConstraints<double>   &constraints,
              const Utilities::MPI::Partitioner &partitioner)
    {
      Tensor<2, dim - 1> ties;
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          const auto *const masters = constraints.get_constraint_entries(
            partitioner.local_to_global(node.horizontal[d]));
          if (masters == nullptr)
            ties[d][d] = 1.;
          else
            for (const auto &[master, weight] : *masters)
              for (unsigned int e = 0; e < dim - 1; ++e)
                if (master == partitioner.local_to_global(node.horizontal[e]))
                  ties[d][e] = weight;
        }
      return ties;
    }
  } // namespace



  template <int dim>
  std::vector<ContactNode<dim>>
  find_contact_nodes(
    const DoFHandler<dim>                                         &dof_handler,
    const AffineConstraints<double>                               &constraints,
    const std::set<types::boundary_id>                            &boundaries,
    const std::function<IndenterSurface<dim>(const Point<dim> &)> &gap,
    const Kinematics                                               kinematics,
    const Vector                                                  &layout)
  {
    Vector areas;
    areas.reinit(layout);
    compute_lumped_areas(
      dof_handler, constraints, boundaries, kinematics, areas);
    const double no_area = 1e-14 * areas.linfty_norm(); // rounding

    std::map<types::global_dof_index, ContactNode<dim>> nodes;
    rethrow_collectively(layout.get_mpi_communicator(), [&]() {
      nodes =
        find_nodes(dof_handler, boundaries, gap, *layout.get_partitioner());
    });

    std::vector<ContactNode<dim>> result;
    for (auto &[dof, node] : nodes)
      {
        node.area = areas.local_element(node.index);
        node.without_area =
          !constraints.is_constrained(dof) && node.area <= no_area;
        node.hanging = constraints.is_constrained(dof) || node.without_area;
        node.ties    = find_ties(node, constraints, *layout.get_partitioner());
        result.push_back(node);
      }
    return result;
  }



  template std::vector<ContactNode<2>>
  find_contact_nodes(
    const DoFHandler<2> &,
    const AffineConstraints<double> &,
    const std::set<types::boundary_id> &,
    const std::function<IndenterSurface<2>(const Point<2> &)> &,
    const Kinematics,
    const Vector &);
  template std::vector<ContactNode<3>>
  find_contact_nodes(
    const DoFHandler<3> &,
    const AffineConstraints<double> &,
    const std::set<types::boundary_id> &,
    const std::function<IndenterSurface<3>(const Point<3> &)> &,
    const Kinematics,
    const Vector &);
} // namespace ElastoPlastic
